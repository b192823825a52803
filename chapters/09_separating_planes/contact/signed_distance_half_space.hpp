/// @file
/// The signed distance of any body and a half-space, in closed form.
#pragma once

#include <concepts>
#include <cstddef>
#include <vector>

#include <contact/convex_shapes.hpp>
#include <contact/plane.hpp>
#include <contact/signed_distance_result.hpp>
#include <contact/support.hpp>
#include <contact/vector.hpp>

namespace contact {

// [signed-distance-half-space]
/// The signed distance of points and a half-space: that of the lowest point, the first of equal
/// ones. The points of a convex hull represent the hull. With a radius, each point is a ball.
/// @param points at least one
/// @param radius m, not negative
/// @return error of the distance: a few u of the coordinates
template <std::floating_point S>
SignedDistance<S> signed_distance(const std::vector<Vector3<S>>& points, const S& radius,
                                  const HalfSpace<S>& b) {
  std::size_t lowest = 0;
  S least = signed_distance(b.boundary, points[0]);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const S other = signed_distance(b.boundary, points[i]);
    if (other < least) {
      least = other;
      lowest = i;
    }
  }
  const Vector3<S>& n = b.boundary.normal;
  return detail::without_negative_zero(detail::signed_distance_of_cores<S>(
      points[lowest], radius, Vector3<S>(points[lowest] - n * least), S(0), least, n));
}
/// A body and a half-space: the lowest vertex of the core, the first of equal ones; of a cylinder
/// or an ellipsoid the point farthest against the normal.
template <ConvexBody A>
SignedDistance<ScalarOf<A>> signed_distance(const A& a, const HalfSpace<ScalarOf<A>>& b) {
  using S = ScalarOf<A>;
  std::vector<Vector3<S>> points;
  if constexpr (PolytopeCore<A>) {
    const int count = vertex_count(a);
    points.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) points.push_back(vertex(a, i));
  } else {
    points.push_back(support(a, Vector3<S>(-b.boundary.normal)));
  }
  return signed_distance<S>(points, radius_of(a), b);
}
/// A half-space and a body.
template <ConvexBody B>
SignedDistance<ScalarOf<B>> signed_distance(const HalfSpace<ScalarOf<B>>& a, const B& b) {
  return exchanged(signed_distance(b, a));
}
// [/signed-distance-half-space]

}  // namespace contact
