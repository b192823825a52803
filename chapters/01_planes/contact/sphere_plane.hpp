/// @file
/// A sphere at rest against a plane.
#pragma once

#include <concepts>

#include <contact/plane.hpp>
#include <contact/shapes.hpp>

namespace contact {

// [sphere-plane]
/// Whether a sphere and a plane have a point in common: |n · c − k| ≤ r. Touching counts.
/// @param sphere with a radius that is not negative, m
/// @param plane with a unit normal; with a longer one the test is wrong by that length
/// @note In a floating-point type it is decided by the rounded distance: certain only if | |n · c −
/// k| − r | exceeds signed_distance_error(plane, c).
/// @see *Interaction and Normals*, slide "Sphere-Plane Intersection"
template <Ring S>
bool sphere_meets_plane(const Sphere<S>& sphere, const Plane<S>& plane) {
  const S distance = signed_distance(plane, sphere.centre);
  return distance <= sphere.radius && -distance <= sphere.radius;
}
// [/sphere-plane]

// [sphere-raw-plane]
/// The same question for a plane whose normal was never normalised: (N · c − K)² ≤ r² N · N.
///
/// Both sides were multiplied by |N| and squared, so there is no square root and no quotient left:
/// with an exact S the answer is exact. In a floating-point type the squares overflow and underflow
/// much sooner than the lengths.
/// @param sphere with a radius that is not negative, m
/// @param plane of any length of normal; N = 0 is no plane, and nothing meets it
template <Ring S>
bool sphere_meets_plane(const Sphere<S>& sphere, const RawPlane<S>& plane) {
  const S length_squared = plane.normal.dot(plane.normal);
  if (!(length_squared > S(0)) || sphere.radius < S(0)) return false;
  const S value = plane.normal.dot(sphere.centre) - plane.offset;
  return value * value <= sphere.radius * sphere.radius * length_squared;
}
// [/sphere-raw-plane]

// [sphere-exact]
/// Whether a sphere and the plane through three points have a point in common: right for all finite
/// numbers, without a tolerance. Collinear points are no plane, and nothing meets them.
/// @param sphere with a radius that is not negative, m
/// @param a, b, c points, m
template <std::floating_point S>
bool sphere_meets_plane_exactly(const Sphere<S>& sphere, const Vector3<S>& a, const Vector3<S>& b,
                                const Vector3<S>& c) {
  const Sphere<Exact> exact{exact_vector(sphere.centre), Exact(double(sphere.radius))};
  return sphere_meets_plane(
      exact, raw_plane_from_points(exact_vector(a), exact_vector(b), exact_vector(c)));
}
// [/sphere-exact]

}  // namespace contact
