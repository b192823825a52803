/// @file
/// The signed distance of a sphere and a cylinder, in closed form.
#pragma once

#include <algorithm>
#include <cmath>

#include <contact/ray_cylinder.hpp>
#include <contact/shapes.hpp>
#include <contact/signed_distance_result.hpp>
#include <contact/support.hpp>
#include <contact/vector.hpp>

namespace contact::detail {

// [signed-distance-sphere-cylinder]
/// The signed distance of a sphere and a cylinder, from the position of the centre along the core
/// and perpendicular to it.
///
/// Beyond a cap or beside the lateral surface, the nearer of the two is closest; beyond both, the
/// rim. A centre inside is moved out through the cap or the lateral surface, whichever is closer;
/// on the core, perpendicular to it in the direction of perpendicular_to().
/// @return error of the distance: a few u of the coordinates, sizes and radii
template <FloatOrDouble S>
SignedDistance<S> closed_distance(const Sphere<S>& a, const Cylinder<S>& b) {
  const Vector3<S> core = b.core.end - b.core.start;
  const Vector3<S> axis = unit_of_any_size<S>(core);
  const Vector3<S> from_start = a.centre - b.core.start, from_end = a.centre - b.core.end;
  const bool behind = axis.dot(from_start) + axis.dot(from_end) < S(0);
  // From the nearer cap, outward.
  const Vector3<S> outward = behind ? Vector3<S>(-axis) : axis;
  const Vector3<S>& from_cap = behind ? from_start : from_end;
  const S beyond = outward.dot(from_cap);
  // Twice, because rounding leaves a component along the core.
  Vector3<S> across = from_cap - axis * axis.dot(from_cap);
  across -= axis * axis.dot(across);
  const S off_axis = length<S>(across), beside = off_axis - b.radius;
  const Vector3<S> side =
      off_axis > S(0) ? Vector3<S>(unit_of_any_size<S>(across)) : perpendicular_to<S>(axis);
  S distance = std::max(beyond, beside);
  Vector3<S> normal = beyond > beside ? outward : side;
  if (beyond > S(0) && beside > S(0)) {
    const Vector3<S> from_rim = outward * beyond + side * beside;
    distance = length<S>(from_rim);
    normal = unit_of_any_size<S>(from_rim);
  }
  return signed_distance_of_cores<S>(a.centre, a.radius, Vector3<S>(a.centre - normal * distance),
                                     S(0), distance, normal);
}
// [/signed-distance-sphere-cylinder]

}  // namespace contact::detail
