/// @file
/// Several contacts without friction: the linear complementarity problem, and its exact solution
/// for a few contacts.
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
  int a = 0;                               ///< index of the body to which the normal points
  int b = 0;                               ///< index of the body from which it points; not a
  Vector3<S> point = Vector3<S>::Zero();   ///< in the world, m
  Vector3<S> normal = Vector3<S>::Zero();  ///< unit vector, from B to A
  S friction = S(0);                       ///< Coulomb's μ, not negative
  /// Lower bound of the normal velocity afterwards, m/s: −e times that before for an impact, 0 for
  /// rest, −distance/h for a gap that may close within a step h.
  S min_velocity = S(0);
};
// [/body-contact]

namespace detail {

/// An index as std::size_t.
inline std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// n · (change of the velocity of `body` at p) for a unit impulse along m at q on the body.
template <Ring S>
S body_inverse_effective_mass(const RigidBody<S>& body, const Vector3<S>& p, const Vector3<S>& n,
                              const Vector3<S>& q, const Vector3<S>& m) {
  const Vector3<S> r = p - body.position;
  const Vector3<S> s = q - body.position;
  const Vector3<S> turned = body.inverse_inertia * Vector3<S>(s.cross(m));
  return body.inverse_mass * S(n.dot(m)) + S(Vector3<S>(r.cross(n)).dot(turned));
}

}  // namespace detail

// [response-matrix]
/// The change of the normal velocity of contact i for a unit impulse along the normal of contact k:
/// the matrix A = J M⁻¹ Jᵀ (Delassus operator), by rows. A is symmetric and positive semidefinite:
/// x · A x is twice a kinetic energy. Its diagonal holds the inverse effective masses.
/// @return 1/kg
template <Ring S>
std::vector<std::vector<S>> inverse_effective_mass_matrix(
    const std::vector<RigidBody<S>>& bodies, const std::vector<BodyContact<S>>& contacts) {
  std::vector<std::vector<S>> matrix(contacts.size(), std::vector<S>(contacts.size(), S(0)));
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      const BodyContact<S>& one = contacts[i];
      const BodyContact<S>& other = contacts[k];
      const auto add = [&](int body, int mine, int theirs, int sign) {
        if (mine != theirs) return;
        const S part = detail::body_inverse_effective_mass<S>(
            bodies[detail::index(body)], one.point, one.normal, other.point, other.normal);
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

/// Solves m x = right by Gaussian elimination with partial pivoting. Nothing if m is singular.
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

/// The largest number of contacts for complementary_impulses(): 2^12 sets are tried.
inline constexpr std::size_t max_exact_contacts = 12;

// [lcp]
/// The linear complementarity problem (LCP): x ≥ 0 and A x + b ≥ 0, and for each i one of the two
/// is 0.
///
/// Each set of indices is tried as the active set, on which x may differ from 0: there A x + b = 0
/// determines x, and x is a solution if neither x nor A x + b has a negative entry. Sets on which A
/// is singular are skipped; for a positive semidefinite A this loses no solvable problem, because a
/// solvable one has a solution whose active columns are linearly independent.
/// @param matrix A, symmetric and positive semidefinite
/// @param constant b, of the same length
/// @return the solution of the first set, in the order of binary numbers; nothing if there is none,
/// which for exact S means that no x ≥ 0 has A x + b ≥ 0
/// @throws std::invalid_argument for more than max_exact_contacts rows
/// @note Exact if S is exact. It is meant for fractions: in a floating-point type a singular set
/// may pass for a regular one
template <Scalar S>
std::optional<std::vector<S>> solve_complementarity(const std::vector<std::vector<S>>& matrix,
                                                    const std::vector<S>& constant) {
  const std::size_t n = constant.size();
  if (n > max_exact_contacts) {
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
/// Applies the impulse of each contact along its normal to A and its opposite to B, in the order of
/// the list.
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
/// The simultaneous impulses of a few contacts without friction: none is negative, no contact is
/// slower than its least velocity afterwards, and a contact with an impulse is not faster
/// (complementarity).
///
/// The friction of the contacts is ignored. The velocities afterwards are the same for all
/// solutions; the impulses need not be unique, as for a table on four legs.
/// @return N·s, one for each contact; nothing if there is no solution, as for two immovable bodies
/// that approach each other
/// @throws std::invalid_argument for more than max_exact_contacts contacts
template <Scalar S>
std::optional<std::vector<S>> complementary_impulses(const std::vector<RigidBody<S>>& bodies,
                                                     const std::vector<BodyContact<S>>& contacts) {
  std::vector<S> constant;
  for (const BodyContact<S>& c : contacts) {
    constant.push_back(contact_velocity(bodies, c) - c.min_velocity);
  }
  return solve_complementarity<S>(inverse_effective_mass_matrix(bodies, contacts), constant);
}
// [/direct]

}  // namespace contact
