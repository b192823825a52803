/// @file
/// When a gap that is quadratic in time closes: the common case of spheres, capsules and planes.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>

#include <contact/exact.hpp>
#include <contact/plane.hpp>
#include <contact/vector.hpp>

namespace contact {

// [entry-terms]
/// The squared distance less the squared sum of the radii, along a straight relative path: square
/// t² − 2 approach t + gap.
template <Ring T>
struct EntryTerms {
  T square;    ///< w · w, with w the relative velocity
  T approach;  ///< −d · w, with d the vector between the centres: positive while they approach
  T gap;       ///< d · d − R²: positive while they are separated
  T depth;     ///< approach² − square gap: negative if they pass without touching

  /// Whether they are separated now and will touch.
  bool enters() const { return T(0) < gap && T(0) < approach && !(depth < T(0)); }

  /// Whether they are separated now and will touch until the time `last`: by then the gap is
  /// closed, or the time of closest approach is past.
  bool enters_by(const T& last) const {
    if (!enters() || last < T(0)) return false;
    if (!(square * last < approach)) return true;
    return !(T(0) < (square * last - approach - approach) * last + gap);
  }
};

/// The terms of two centres: d from b to a, w the velocity of a relative to b, and R the sum of the
/// radii.
///
/// The depth is R² w·w − |d × w|², by Lagrange's identity: the form of the definition cancels much
/// more.
template <Ring T>
EntryTerms<T> entry_terms(const Vector3<T>& d, const Vector3<T>& w, const T& radius_sum) {
  const T square = w.dot(w);
  const Vector3<T> across = d.cross(w);
  return {square, -d.dot(w), d.dot(d) - radius_sum * radius_sum,
          radius_sum * radius_sum * square - across.dot(across)};
}
// [/entry-terms]

// [entry-time]
/// The time at which exactly known terms enter: (approach − √depth) / square, written as (gap /
/// approach) / (1 + √(depth / approach²)), in which nothing cancels.
///
/// Two quotients, a root, a sum and a quotient are rounded: the relative error is at most 4 u,
/// without underflow. The radicand is between 0 and 1, so its overflow or underflow cannot matter.
/// @param terms with enters()
/// @return ∞ beyond the largest finite number
template <std::floating_point S>
S entry_time(const EntryTerms<Exact>& terms) {
  const S share = quotient<S>(terms.depth, terms.approach * terms.approach);
  return quotient<S>(terms.gap, terms.approach) / (S(1) + std::sqrt(share));
}
// [/entry-time]

/// The difference a − b of stored vectors, computed exactly.
template <std::floating_point S>
Vector3<Exact> exact_vector_difference(const Vector3<S>& a, const Vector3<S>& b) {
  return exact_vector(a) - exact_vector(b);
}

}  // namespace contact
