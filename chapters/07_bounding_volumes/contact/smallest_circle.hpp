/// @file
/// The smallest circle that encloses points of the plane, decided without error, and the lecture's
/// circle in the plane.
#pragma once

#include <algorithm>
#include <array>
#include <contact/enclosing_radius.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/grown_sphere.hpp>
#include <contact/smallest_sphere.hpp>
#include <contact/vector.hpp>
#include <span>
#include <vector>

namespace contact {

/// All points of the plane at most radius from centre.
template <Ring S>
struct Circle {
  Vector2<S> centre = Vector2<S>::Zero();  ///< m
  S radius = S(0);                         ///< m, not negative
};

/// The smallest circle that encloses points, and points that determine it.
template <FloatOrDouble S>
struct SmallestCircle {
  /// Its centre, each coordinate the number of S nearest to the exact one, and the smallest radius
  /// about this centre that encloses all points, m.
  Circle<S> circle;
  /// Indices of points on it, in increasing order, whose own smallest circle is this one; −1 beyond
  /// support_count.
  std::array<int, 3> support{-1, -1, -1};
  /// How many: from 1 to 3. None of them can be left out.
  int support_count = 0;
  /// The square of the exact radius, rounded to the nearest double, m²; 0 or infinite beyond the
  /// range of double.
  double radius_squared = 0;
};

namespace sphere_detail {

/// The points in the plane z = 0.
template <FloatOrDouble S>
std::vector<Vector3<S>> in_space(std::span<const Vector2<S>> points) {
  std::vector<Vector3<S>> lifted;
  lifted.reserve(points.size());
  for (const Vector2<S>& p : points) lifted.emplace_back(p.x(), p.y(), S(0));
  return lifted;
}

}  // namespace sphere_detail

// [smallest-circle]
/// The smallest circle that encloses all points, decided without error.
///
/// It is where the smallest sphere of the same points meets their plane: the sphere's centre is in
/// the convex hull of its support, and so in the plane, and a smaller circle would be the equator
/// of a smaller sphere. Four points of a plane are no support, since one weight would not be
/// needed.
/// @param points n ≥ 1 points, m, finite, of any magnitude, in any order
/// @throws std::invalid_argument if there is no point, a coordinate is not finite, or the radius
/// overflows
template <FloatOrDouble S>
SmallestCircle<S> smallest_circle(std::span<const Vector2<S>> points) {
  const std::vector<Vector3<S>> lifted = sphere_detail::in_space(points);
  const SmallestSphere<S> found = smallest_sphere<S>(lifted);
  SmallestCircle<S> result;
  result.circle = {found.sphere.centre.template head<2>(), found.sphere.radius};
  std::copy_n(found.support.begin(), 3, result.support.begin());
  result.support_count = found.support_count;
  result.radius_squared = found.radius_squared;
  return result;
}
// [/smallest-circle]

/// The lecture's circle, certain to contain every point: see grown_sphere().
/// @param points n ≥ 1 points, m, finite, of any magnitude
/// @throws std::invalid_argument if there is no point, a coordinate is not finite, or the radius
/// overflows
template <FloatOrDouble S>
Circle<S> grown_circle(std::span<const Vector2<S>> points) {
  const Sphere<S> sphere = grown_sphere<S>(sphere_detail::in_space(points));
  return {sphere.centre.template head<2>(), sphere.radius};
}

}  // namespace contact
