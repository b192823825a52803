/// @file
/// The signed distance of spheres and capsules, in closed form.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>

#include <contact/capsule.hpp>
#include <contact/closest_points.hpp>
#include <contact/exact.hpp>
#include <contact/signed_distance_result.hpp>
#include <contact/vector.hpp>

namespace contact::detail {

// [signed-distance-spheres]
/// The signed distance of two spheres. If the centres coincide, all directions are equivalent, and
/// z is taken.
/// @return error of the distance: a few u of the coordinates and radii
template <FloatOrDouble S>
SignedDistance<S> closed_distance(const Sphere<S>& a, const Sphere<S>& b) {
  const Vector3<S> between = a.centre - b.centre;
  const Vector3<S> normal =
      between == Vector3<S>::Zero() ? Vector3<S>(Vector3<S>::UnitZ()) : normalised<S>(between);
  return signed_distance_of_cores<S>(a.centre, a.radius, b.centre, b.radius, length<S>(between),
                                     normal);
}
// [/signed-distance-spheres]

/// The unit vector along d × e: exact but for the last rounding if the angle between the two is
/// small. 0 if they are parallel.
template <FloatOrDouble S>
Vector3<S> cross_direction(const Vector3<S>& d, const Vector3<S>& e) {
  const Vector3<S> rounded = d.cross(e);
  if (length<S>(rounded) > length<S>(d) * length<S>(e) * S(0x1p-10)) {
    return normalised<S>(rounded);
  }
  const Vector3<Exact> exact = exact_vector<S>(d).cross(exact_vector<S>(e));
  const Vector3<double> direction = rounded_direction(exact);
  if (direction == Vector3<double>::Zero()) return Vector3<S>::Zero();
  return normalised<double>(direction).template cast<S>();
}

// [signed-distance-capsules]
/// The signed distance of two capsules: that of the closest points of their segments, less the
/// radii.
///
/// If the segments cross, their closest points define no direction. Then the shortest translation
/// is perpendicular to both. If they almost cross, the direction is that of the exact closest
/// points: the difference of the rounded ones would be off by an ulp divided by their distance.
/// @return error of the distance: a few u of the coordinates and radii
template <FloatOrDouble S>
SignedDistance<S> closed_distance(const Capsule<S>& a, const Capsule<S>& b) {
  const ClosestPoints<S> near = closest_points<S>(a.core, b.core);
  const Vector3<S> between = near.on_a - near.on_b;
  const S distance = length<S>(between);
  const S size = std::max(largest_coordinate<S>(a.core.start, a.core.end),
                          largest_coordinate<S>(b.core.start, b.core.end));
  const auto along = [&](const S& apart, const Vector3<S>& normal) {
    return signed_distance_of_cores<S>(near.on_a, a.radius, near.on_b, b.radius, apart, normal);
  };
  if (!is_near(distance, size)) return along(distance, normalised<S>(between));
  const CoreDirection<S> exact = core_direction(a, b);
  if (exact.normal != Vector3<S>::Zero()) return along(exact.distance, exact.normal);
  const Vector3<S> d = a.core.end - a.core.start;
  const Vector3<S> e = b.core.end - b.core.start;
  const Vector3<S> normal = cross_direction<S>(d, e);
  if (normal != Vector3<S>::Zero()) return along(S(0), normal);
  return along(S(0), perpendicular_to<S>(d == Vector3<S>::Zero() ? e : d));
}
/// A sphere and a capsule.
template <FloatOrDouble S>
SignedDistance<S> closed_distance(const Sphere<S>& a, const Capsule<S>& b) {
  return closed_distance(as_capsule(a), b);
}
// [/signed-distance-capsules]

}  // namespace contact::detail
