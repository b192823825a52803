/// @file
/// Several contacts at once, without friction: what they demand together, and an exact answer for a
/// few.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <contact/invalid_argument.hpp>
#include <contact/rigid_body.hpp>
#include <contact/rigid_impulse.hpp>
#include <contact/vector.hpp>

namespace contact {

// [body-contact]
/// A contact between two bodies of a list.
template <Ring S>
struct BodyContact {
  int a = 0;                               ///< which body the normal points to
  int b = 0;                               ///< which body it comes from; not a
  Vector3<S> point = Vector3<S>::Zero();   ///< in the world, m
  Vector3<S> normal = Vector3<S>::Zero();  ///< unit vector, from B to A
  S friction = S(0);                       ///< Coulomb's μ, not negative
  /// The normal velocity must end up at least here, m/s: −e times that before for an impact, 0 for
  /// rest, −distance/h to close a gap in a step h and no more.
  S least_velocity = S(0);
};
// [/body-contact]

namespace detail {

/// Position in a list.
inline std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// n · (change of the velocity of `body` at p) for a unit impulse along m at q on it.
template <Ring S>
S body_response(const RigidBody<S>& body, const Vector3<S>& p, const Vector3<S>& n,
                const Vector3<S>& q, const Vector3<S>& m) {
  const Vector3<S> r = p - body.position;
  const Vector3<S> s = q - body.position;
  const Vector3<S> turned = body.inverse_inertia * Vector3<S>(s.cross(m));
  return body.inverse_mass * S(n.dot(m)) + S(Vector3<S>(r.cross(n)).dot(turned));
}

}  // namespace detail

// [response-matrix]
/// How much a unit of impulse at contact k along its normal changes the normal velocity of contact
/// i: a symmetric matrix A, row after row. It is never negative: x · A x is twice an energy.
/// @return 1/kg
template <Ring S>
std::vector<std::vector<S>> response_matrix(const std::vector<RigidBody<S>>& bodies,
                                            const std::vector<BodyContact<S>>& contacts) {
  std::vector<std::vector<S>> matrix(contacts.size(), std::vector<S>(contacts.size(), S(0)));
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      const BodyContact<S>& one = contacts[i];
      const BodyContact<S>& other = contacts[k];
      const auto add = [&](int body, int mine, int theirs, int sign) {
        if (mine != theirs) return;
        const S part = detail::body_response<S>(bodies[detail::index(body)], one.point, one.normal,
                                                other.point, other.normal);
        matrix[i][k] = sign > 0 ? S(matrix[i][k] + part) : S(matrix[i][k] - part);
      };
      add(one.a, one.a, other.a, 1);
      add(one.b, one.b, other.b, 1);
      add(one.a, one.a, other.b, -1);
      add(one.b, one.b, other.a, -1);
    }
  }
  return matrix;
}
// [/response-matrix]

/// The normal velocity of a contact: n · (v_A(p) − v_B(p)), m/s.
template <Ring S>
S contact_velocity(const std::vector<RigidBody<S>>& bodies, const BodyContact<S>& contact) {
  const Vector3<S> relative = velocity_at(bodies[detail::index(contact.a)], contact.point) -
                              velocity_at(bodies[detail::index(contact.b)], contact.point);
  return contact.normal.dot(relative);
}

namespace detail {

/// Solves m x = right by elimination, with the largest pivot of each column. Nothing if m is
/// singular.
template <Scalar S>
std::optional<std::vector<S>> solve_linear(std::vector<std::vector<S>> m, std::vector<S> right) {
  const std::size_t n = right.size();
  const auto size = [](const S& x) { return x < S(0) ? S(-x) : x; };
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    for (std::size_t r = c + 1; r < n; ++r) {
      if (size(m[pivot][c]) < size(m[r][c])) pivot = r;
    }
    if (m[pivot][c] == S(0)) return std::nullopt;
    std::swap(m[pivot], m[c]);
    std::swap(right[pivot], right[c]);
    for (std::size_t r = c + 1; r < n; ++r) {
      const S f = m[r][c] / m[c][c];
      for (std::size_t k = c; k < n; ++k) m[r][k] = m[r][k] - f * m[c][k];
      right[r] = right[r] - f * right[c];
    }
  }
  std::vector<S> x(n, S(0));
  for (std::size_t c = n; c-- > 0;) {
    S sum = right[c];
    for (std::size_t k = c + 1; k < n; ++k) sum = sum - m[c][k] * x[k];
    x[c] = sum / m[c][c];
  }
  return x;
}

}  // namespace detail

/// The most contacts that complementary_impulses() takes: 2^12 sets are tried.
inline constexpr std::size_t most_exact_contacts = 12;

// [lcp]
/// The linear complementarity problem: x ≥ 0 with A x + b ≥ 0, and for each i one of the two 0.
///
/// Each set of indices is tried for being the one where x may differ from 0: on it A x + b = 0
/// gives x, and x is the answer if nothing is negative. Sets on which A is singular are left out;
/// for a symmetric A that is never negative another set does for them, because of all answers one
/// has independent columns.
/// @param matrix A, symmetric, with x · A x ≥ 0
/// @param constant b, as long
/// @return the answer of the first set, in the order of binary numbers; nothing if there is none,
/// which for exact S means that no x ≥ 0 has A x + b ≥ 0
/// @throws std::invalid_argument for more than most_exact_contacts rows
/// @note Exact if S is exact. In a floating-point type a singular set may pass for a regular one:
/// meant for fractions
template <Scalar S>
std::optional<std::vector<S>> solve_complementarity(const std::vector<std::vector<S>>& matrix,
                                                    const std::vector<S>& constant) {
  const std::size_t n = constant.size();
  if (n > most_exact_contacts) {
    throw_invalid_argument("constant", std::to_string(n) + " rows", "at most 12 can be tried");
  }
  for (std::uint32_t set = 0; set < (std::uint32_t{1} << n); ++set) {
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < n; ++i) {
      if (((set >> i) & 1U) != 0) chosen.push_back(i);
    }
    std::vector<std::vector<S>> part;
    std::vector<S> right;
    for (const std::size_t i : chosen) {
      part.emplace_back();
      for (const std::size_t k : chosen) part.back().push_back(matrix[i][k]);
      right.push_back(S(-constant[i]));
    }
    const auto solved = detail::solve_linear<S>(part, right);
    if (!solved) continue;
    std::vector<S> x(n, S(0));
    bool allowed = true;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      x[chosen[i]] = (*solved)[i];
      allowed = allowed && !((*solved)[i] < S(0));
    }
    for (std::size_t i = 0; i < n && allowed; ++i) {
      if (((set >> i) & 1U) != 0) continue;
      S rest = constant[i];
      for (const std::size_t k : chosen) rest = rest + matrix[i][k] * x[k];
      allowed = !(rest < S(0));
    }
    if (allowed) return x;
  }
  return std::nullopt;
}
// [/lcp]

// [apply]
/// Gives each contact's impulse along its normal to A and takes it from B, in the order of the
/// list.
template <Ring S>
std::vector<RigidBody<S>> after_normal_impulses(std::vector<RigidBody<S>> bodies,
                                                const std::vector<BodyContact<S>>& contacts,
                                                const std::vector<S>& impulses) {
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const BodyContact<S>& c = contacts[i];
    const Vector3<S> impulse = c.normal * impulses[i];
    RigidBody<S>& a = bodies[detail::index(c.a)];
    RigidBody<S>& b = bodies[detail::index(c.b)];
    a = after_impulse<S>(a, impulse, c.point);
    b = after_impulse<S>(b, Vector3<S>(-impulse), c.point);
  }
  return bodies;
}
// [/apply]

// [direct]
/// The impulses of a few contacts without friction, all at once: each pushes or does nothing, no
/// contact ends up slower than its least velocity, and none that pushes ends up faster.
///
/// Friction is left out, whatever the contacts say. The velocities afterwards are the same for all
/// answers; the impulses need not be, as four legs of a table share its weight in many ways.
/// @return N·s, one a contact; nothing if no impulses do it: two immovable bodies that close
/// @throws std::invalid_argument for more than most_exact_contacts contacts
template <Scalar S>
std::optional<std::vector<S>> complementary_impulses(const std::vector<RigidBody<S>>& bodies,
                                                     const std::vector<BodyContact<S>>& contacts) {
  std::vector<S> constant;
  for (const BodyContact<S>& c : contacts) {
    constant.push_back(contact_velocity(bodies, c) - c.least_velocity);
  }
  return solve_complementarity<S>(response_matrix(bodies, contacts), constant);
}
// [/direct]

}  // namespace contact
