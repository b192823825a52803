/// @file
/// When iterations over contacts end: the residual of complementarity and of Coulomb's law, and the
/// rounding below which it cannot come.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <vector>

#include <contact/contact_block.hpp>
#include <contact/contact_iterations.hpp>
#include <contact/friction_pyramid.hpp>
#include <contact/rigid_body.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// A bound on the error of velocities from rounded impulses. Between two heavy bodies, large
/// changes of the velocity of a light one cancel, but their rounding errors do not: for doubles
/// 2⁻⁴⁴ of the sum of their absolute values.
template <std::floating_point S>
S impulse_rounding(const std::vector<RigidBody<S>>& bodies,
                   const std::vector<PreparedContact<S>>& contacts,
                   const std::vector<ImpulseComponents<S>>& impulses) {
  std::vector<S> changes(bodies.size(), S(0));
  S most(0);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const PreparedContact<S>& p = contacts[i];
    for (const bool first : {true, false}) {
      const std::size_t body_index = index(first ? p.contact.a : p.contact.b);
      const RigidBody<S>& body = bodies[body_index];
      const Vector3<S> lever_arm = p.contact.point - body.position;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vector3<S>& turn = first ? p.angular_a[k] : p.angular_b[k];
        changes[body_index] +=
            std::abs(impulses[i][k]) *
            (body.inverse_mass + std::sqrt(S(turn.dot(turn)) * S(lever_arm.dot(lever_arm))));
      }
      most = std::max(most, changes[body_index]);
    }
  }
  return S(256) * std::numeric_limits<S>::epsilon() * most;
}

// [residual]
/// By how much the velocity of one contact would change if its impulses alone were corrected, m/s:
/// 0 if complementarity and Coulomb's law hold there, and only then.
///
/// The normal impulse would become max(0, x − w / k), with the normal velocity w above its minimum
/// and the inverse effective mass k: no change means x ≥ 0, w ≥ 0 and x = 0 or w = 0. Friction
/// would become the point of its disc (or square) nearest to x − s / k, with the slip s: no change
/// means that s = 0, or that friction is on the boundary of the disc, opposite to s.
/// @param x of two immovable bodies 0 (clamped_impulses())
/// @return between immovable bodies, how fast they close
template <std::floating_point S>
S contact_residual(const std::vector<RigidBody<S>>& bodies, const PreparedContact<S>& p,
                   const ImpulseComponents<S>& x) {
  const Vector3<S> relative = relative_velocity(bodies, p.contact);
  const S opening = p.direction[0].dot(relative) - p.contact.min_velocity;
  if (!(p.inverse_normal_mass > S(0))) return std::max(S(0), -opening);
  const S normal = std::abs(std::min(x[0] * p.inverse_normal_mass, opening));
  if (!(p.contact.friction > S(0)) || !(p.inverse_tangent_mass > S(0))) return normal;
  const S one = x[1] - relative.dot(p.direction[1]) / p.inverse_tangent_mass;
  const S two = x[2] - relative.dot(p.direction[2]) / p.inverse_tangent_mass;
  const Vector2<S> next = bounded_friction<S>(p.bound, {one, two}, p.contact.friction * x[0]);
  return std::max(normal,
                  disc_length<S>(next.x() - x[1], next.y() - x[2]) * p.inverse_tangent_mass);
}
// [/residual]

/// The largest contact_residual(), for bodies after the impulses. NaN if one is.
/// @param movable_only leaves out contacts of two immovable bodies, which no impulse can change
template <std::floating_point S>
S largest_residual(const std::vector<RigidBody<S>>& bodies,
                   const std::vector<PreparedContact<S>>& contacts,
                   const std::vector<ImpulseComponents<S>>& impulses, bool movable_only = false) {
  S largest(0);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (movable_only && !(contacts[i].inverse_normal_mass > S(0))) continue;
    const S residual = contact_residual(bodies, contacts[i], impulses[i]);
    if (std::isnan(residual)) return residual;
    largest = std::max(largest, residual);
  }
  return largest;
}

/// Without a smaller change than before in this many iterations, relaxation is reduced.
inline constexpr int settling_iterations = 1024;

/// The least relaxation to which it is reduced.
inline constexpr double min_relaxation = 0x1p-6;

// [iterate]
/// Iterates from impulses, which are replaced, until they have settled or the iterations are used
/// up. A fixed point of rounding ends them too: an iteration that changes nothing.
template <std::floating_point S>
SolverReport<S> iterate_until(std::vector<RigidBody<S>> bodies,
                              const std::vector<PreparedContact<S>>& contacts,
                              std::vector<ImpulseComponents<S>>& impulses,
                              const SolverSettings<S>& limits) {
  if (limits.jacobi) {
    apply_together(bodies, contacts, impulses);
  } else {
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) apply_impulse(bodies, contacts[i], k, impulses[i][k]);
    }
  }
  SolverReport<S> report;
  S relaxation = limits.jacobi ? S(1) : limits.relaxation;
  S least = std::numeric_limits<S>::infinity();  // smallest change in these iterations
  S min_before = least;
  const std::vector<int> partners = limits.jacobi ? busiest(bodies, contacts) : std::vector<int>();
  const std::vector<ContactBlock<S>> blocks = limits.jacobi
                                                  ? std::vector<ContactBlock<S>>()
                                                  : contact_blocks(bodies, contacts, limits.block);
  const auto settled = [&] {
    if (report.last_change > limits.tolerance) return false;
    if (!(report.last_change > S(0))) return true;
    if (largest_residual(bodies, contacts, impulses, true) <=
        limits.tolerance + impulse_rounding(bodies, contacts, impulses))
      return true;
    relaxation = std::min(relaxation, S(1));  // over-relaxed, they might move away again
    return false;
  };
  do {
    report.last_change = limits.jacobi
                             ? jacobi_iteration(bodies, contacts, impulses, partners, relaxation)
                             : block_iteration(bodies, contacts, impulses, relaxation, blocks);
    ++report.iterations;
    least = std::min(least, report.last_change);
    if (report.iterations % settling_iterations != 0) continue;
    min_before = least < min_before ? least : std::numeric_limits<S>::infinity();
    if (!std::isfinite(min_before))
      relaxation = relaxation > S(1) ? S(1) : std::max(relaxation / S(2), S(min_relaxation));
    least = std::numeric_limits<S>::infinity();
  } while (report.iterations < limits.iterations && !settled());
  return report;
}
// [/iterate]

}  // namespace detail

}  // namespace contact
