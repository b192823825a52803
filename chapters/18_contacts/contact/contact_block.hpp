/// @file
/// Block solve: iterations that solve two contacts of the same bodies at once.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <vector>

#include <contact/contact_iterations.hpp>
#include <contact/contact_lcp.hpp>
#include <contact/rigid_body.hpp>
#include <contact/two_contacts.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// A contact of the list, or two that follow each other and have the same bodies.
template <std::floating_point S>
struct ContactBlock {
  std::size_t first = 0;
  bool two = false;
  TwoContactMatrix<S> matrix;  ///< of the two normals
  bool regular = false;        ///< whether the determinant of the matrix is more than rounding
};

/// Whether the determinant of a rounded matrix is more than rounding may make of 0. The bound is
/// for entries off by up to 32 u, which is far more than they usually are.
template <std::floating_point S>
bool is_regular(const TwoContactMatrix<S>& matrix) {
  const S determinant_share =
      S(1) - (matrix.coupling / matrix.first) * (matrix.coupling / matrix.second);
  return determinant_share > S(64) * std::numeric_limits<S>::epsilon();
}

/// The list of contacts as blocks.
/// @param pairs whether there are blocks of two
template <std::floating_point S>
std::vector<ContactBlock<S>> contact_blocks(const std::vector<RigidBody<S>>& bodies,
                                            const std::vector<PreparedContact<S>>& contacts,
                                            bool pairs) {
  std::vector<ContactBlock<S>> blocks;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    ContactBlock<S> block{i, false, {}, false};
    const BodyContact<S>& c = contacts[i].contact;
    if (pairs && i + 1 < contacts.size() && contacts[i].inverse_normal_mass > S(0) &&
        contacts[i + 1].contact.a == c.a && contacts[i + 1].contact.b == c.b) {
      const BodyContact<S>& d = contacts[i + 1].contact;
      const auto coupling = [&](int body) {
        return body_inverse_effective_mass<S>(bodies[index(body)], c.point, c.normal, d.point,
                                              d.normal);
      };
      block.two = true;
      block.matrix = {contacts[i].inverse_normal_mass, coupling(c.a) + coupling(c.b),
                      contacts[i + 1].inverse_normal_mass};
      block.regular = is_regular(block.matrix);
      ++i;
    }
    blocks.push_back(block);
  }
  return blocks;
}

// [block-solve]
/// Updates the impulses of two contacts of the same bodies: friction of each as in relax(), then
/// both normals at once, then friction again where a normal impulse became smaller.
///
/// The accumulated normal impulses solve the linear complementarity problem of the two, with the
/// impulses of all other contacts as they are: the minimum of the energy function over both, to
/// which one after the other goes in steps. If there is none (two contacts that oppose each other),
/// they are updated one after the other; also if both push and the matrix may be singular, because
/// impulses divided by a determinant that is only rounding would be arbitrarily large.
template <std::floating_point S>
S relax_two(std::vector<RigidBody<S>>& bodies, const PreparedContact<S>& one,
            const PreparedContact<S>& two, const ContactBlock<S>& block, ImpulseComponents<S>& x,
            ImpulseComponents<S>& y, const S& relaxation) {
  const TwoContactMatrix<S>& matrix = block.matrix;
  const S first = relax_friction(bodies, one, x, relaxation);
  const S friction = std::max(first, relax_friction(bodies, two, y, relaxation));
  const auto opening = [&](const PreparedContact<S>& p) {
    return p.direction[0].dot(relative_velocity(bodies, p.contact)) - p.contact.min_velocity;
  };
  const S v = opening(one) - (matrix.first * x[0] + matrix.coupling * y[0]);
  const S w = opening(two) - (matrix.coupling * x[0] + matrix.second * y[0]);
  auto solved = solve_two_contacts<S>(matrix, v, w);
  if (solved && solved->pushes == TwoContactCase::both && !block.regular) solved.reset();
  const S normal =
      solved ? change_normal(bodies, one, x, solved->first) : relax_normal(bodies, one, x, S(1));
  const S other =
      solved ? change_normal(bodies, two, y, solved->second) : relax_normal(bodies, two, y, S(1));
  return std::max({friction, normal, other});
}
// [/block-solve]

/// One iteration over all blocks, in the order of the list. Without blocks of two it is
/// gauss_seidel_iteration(), to the last bit.
template <std::floating_point S>
S block_iteration(std::vector<RigidBody<S>>& bodies,
                  const std::vector<PreparedContact<S>>& contacts,
                  std::vector<ImpulseComponents<S>>& impulses, const S& relaxation,
                  const std::vector<ContactBlock<S>>& blocks) {
  S largest(0);
  for (const ContactBlock<S>& block : blocks) {
    const std::size_t i = block.first;
    if (!(contacts[i].inverse_normal_mass > S(0))) continue;  // two immovable bodies
    const S change = block.two ? relax_two(bodies, contacts[i], contacts[i + 1], block, impulses[i],
                                           impulses[i + 1], relaxation)
                               : relax(bodies, contacts[i], impulses[i], relaxation);
    largest = std::max(largest, change);
  }
  return largest;
}

}  // namespace detail

}  // namespace contact
