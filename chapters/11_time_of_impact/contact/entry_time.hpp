/// @file
/// When a gap that is quadratic in time closes: what spheres, capsules and planes all come down to.
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
/// The squared distance less the squared reach, as it changes on a straight way:
/// square t² − 2 approach t + gap.
template <Ring T>
struct EntryTerms {
  T square;    ///< w · w, with w the relative velocity
  T approach;  ///< −d · w, with d the vector between the centres: positive while they come closer
  T gap;       ///< d · d − R²: positive while they are apart
  T depth;     ///< approach² − square gap: negative if they pass each other by

  /// Whether they are apart now, and will touch.
  bool enters() const { return T(0) < gap && T(0) < approach && !(depth < T(0)); }

  /// Whether they are apart now, and will touch at the time `last` or before: by then the gap is
  /// closed, or the nearest moment is past.
  bool enters_by(const T& last) const {
    if (!enters() || last < T(0)) return false;
    if (!(square * last < approach)) return true;
    return !(T(0) < (square * last - approach - approach) * last + gap);
  }
};

/// The terms of two centres: d from b to a, w the velocity of a less that of b, and the reach R.
///
/// The depth is R² w·w − |d × w|², by Lagrange's identity: that of the definition cancels much
/// more.
template <Ring T>
EntryTerms<T> entry_terms(const Vector3<T>& d, const Vector3<T>& w, const T& reach) {
  const T square = w.dot(w);
  const Vector3<T> across = d.cross(w);
  return {square, -d.dot(w), d.dot(d) - reach * reach, reach * reach * square - across.dot(across)};
}
// [/entry-terms]

// [entry-time]
/// The time at which terms that are known exactly enter: (approach − √depth) / square, written as
/// (gap / approach) / (1 + √(depth / approach²)), in which nothing cancels.
///
/// Two quotients are rounded once each, then a root, a sum and a quotient: at most 4 u of the
/// result, if it does not underflow. The part under the root is between 0 and 1, so it neither
/// over- nor underflows in a way that matters.
/// @param terms with enters()
/// @return ∞ if it is beyond the largest number
template <std::floating_point S>
S entry_time(const EntryTerms<Exact>& terms) {
  const S share = quotient<S>(terms.depth, terms.approach * terms.approach);
  return quotient<S>(terms.gap, terms.approach) / (S(1) + std::sqrt(share));
}
// [/entry-time]

/// The difference a − b of stored vectors, without rounding.
template <std::floating_point S>
Vector3<Exact> exact_vector_difference(const Vector3<S>& a, const Vector3<S>& b) {
  return exact_vector(a) - exact_vector(b);
}

}  // namespace contact
