/// @file
/// What the exercises' tests of this chapter know for sure of a line and a body: decisions and
/// coefficients without rounding, so that each number is rounded a few times at most, at the end.
/// It needs no library, so it works wherever the tests do.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <contact/exact.hpp>
#include <contact/vector.hpp>

namespace exact {

using contact::Exact;
using Vector = contact::Vector3<Exact>;

inline Vector exactly(const Eigen::Vector3d& v) {
  return {Exact(v.x()), Exact(v.y()), Exact(v.z())};
}
inline Exact dot(const Vector& u, const Vector& v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}
inline Vector cross(const Vector& u, const Vector& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

/// The t of a line that are in a convex body: from entry to exit, each to a few units of its last
/// place, and their exact signs.
struct Interval {
  double entry = -std::numeric_limits<double>::infinity();
  double exit = std::numeric_limits<double>::infinity();
  int sign_of_entry = -1;
  int sign_of_exit = 1;
};

/// Where a t² + 2 b t + c ≤ 0; nothing if that is nowhere. a must not be negative; if it is 0, b
/// must be 0.
inline std::optional<Interval> at_most_zero(const Exact& a, const Exact& b, const Exact& c) {
  if (a.sign() == 0) return c.sign() > 0 ? std::nullopt : std::optional(Interval{});
  const Exact discriminant = b * b - a * c;
  if (discriminant.sign() < 0) return std::nullopt;
  const double root = std::sqrt(rounded<double>(discriminant));
  const double q = -rounded<double>(b) + (b.sign() > 0 ? -root : root);
  // The other root by the product of the roots; both are 0 if q is.
  double first = q / rounded<double>(a), second = q == 0 ? 0 : rounded<double>(c) / q;
  if (b.sign() <= 0) std::swap(first, second);
  // Both roots have the sign of -b if c > 0. If c is 0 one of them is 0, and the other has it.
  const int ahead = -b.sign();
  if (c.sign() > 0) return Interval{first, second, ahead, ahead};
  if (c.sign() < 0) return Interval{first, second, -1, 1};
  return Interval{first, second, ahead < 0 ? -1 : 0, ahead > 0 ? 1 : 0};
}

/// Where low ≤ at + t along ≤ high; nothing if that is nowhere.
inline std::optional<Interval> between(const Exact& at, const Exact& along, const Exact& low,
                                       const Exact& high) {
  Exact to_near = low - at, to_far = high - at;
  if (along.sign() == 0)
    return to_near.sign() > 0 || to_far.sign() < 0 ? std::nullopt : std::optional(Interval{});
  if (along.sign() < 0) std::swap(to_near, to_far);
  return Interval{quotient<double>(to_near, along), quotient<double>(to_far, along),
                  to_near.sign() * along.sign(), to_far.sign() * along.sign()};
}

}  // namespace exact
