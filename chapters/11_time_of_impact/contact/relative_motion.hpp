/// @file
/// Two centres that move at the same time: paths that cross, and when the centres are closest.
#pragma once

#include <cmath>
#include <concepts>
#include <limits>

#include <contact/entry_time.hpp>
#include <contact/exact.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/sign_with_root.hpp>
#include <contact/swept_volumes.hpp>
#include <contact/vector.hpp>

namespace contact {

// [moving-point]
/// A point that moves in a straight line at constant velocity during a step.
template <FloatOrDouble S>
struct MovingPoint {
  Vector3<S> start = Vector3<S>::Zero();         ///< m
  Vector3<S> displacement = Vector3<S>::Zero();  ///< in the step, m
};
// [/moving-point]

/// The time at which two moving points are closest.
template <FloatOrDouble S>
struct ClosestApproach {
  S t = S(0);         ///< fraction of the step, from 0 to 1
  S distance = S(0);  ///< of the points at that time, m
};

// [closest-approach]
/// When two moving points are closest, and how close.
///
/// Described relative to b, a is at d + w t, with the differences d and w of the starts and the
/// displacements: one moving point and one at rest. The squared distance is a quadratic with its
/// minimum at −d · w / w · w, or at an end of the step. At that time the square of the distance is
/// |d × w|² / w · w, in which nothing cancels.
///
/// The distance of the paths is another number: the points can pass the same position at different
/// times. See paths_meet().
/// @param a, b finite
/// @return t is rounded once, the distance at most four times: they are computed without rounding
/// up to a quotient and a root. If the motion is the same, t is 0. If a number is not finite, both
/// are NaN. A distance beyond the largest number is ∞
template <FloatOrDouble S>
ClosestApproach<S> closest_approach(const MovingPoint<S>& a, const MovingPoint<S>& b) {
  if (!all_finite(a.start) || !all_finite(a.displacement) || !all_finite(b.start) ||
      !all_finite(b.displacement)) {
    constexpr S nan = std::numeric_limits<S>::quiet_NaN();
    return {nan, nan};
  }
  const Vector3<Exact> d = exact_vector_difference(a.start, b.start);
  const Vector3<Exact> w = exact_vector_difference(a.displacement, b.displacement);
  const Exact approach = -d.dot(w);
  const Exact square = w.dot(w);
  const auto length = [](const Exact& squared, const Exact& over) {
    return static_cast<S>(detail::root_of_quotient(squared, over));
  };
  if (approach.sign() <= 0) return {S(0), length(d.dot(d), Exact(1.0))};
  if (square <= approach) {
    const Vector3<Exact> end = d + w;
    return {S(1), length(end.dot(end), Exact(1.0))};
  }
  const Vector3<Exact> across = d.cross(w);
  return {quotient<S>(approach, square), length(across.dot(across), square)};
}
// [/closest-approach]

// [paths-meet]
/// Whether the paths of two moving points, as segments without time, come as close as `distance`.
///
/// Paths that do not meet prove that the points do not. Paths that do prove nothing: the points may
/// pass the crossing at different times, so only closest_approach() decides.
/// @param distance m, finite and not negative
/// @return right for every finite input; touching counts. False if a number is not finite
template <FloatOrDouble S>
bool paths_meet(const MovingPoint<S>& a, const MovingPoint<S>& b, S distance) {
  if (!all_finite(a.start) || !all_finite(a.displacement) || !all_finite(b.start) ||
      !all_finite(b.displacement) || !(distance >= S(0)) || !std::isfinite(distance)) {
    return false;
  }
  return detail::segments_within(exact_vector_difference(b.start, a.start),
                                 exact_vector(a.displacement), exact_vector(b.displacement),
                                 Exact(double(distance)));
}
// [/paths-meet]

}  // namespace contact
