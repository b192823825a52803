/// @file
/// Lozenges, ellipsoids and convex hulls as plain data, and constructions of these and of cylinders
/// and triangles from input.
#pragma once

#include <concepts>
#include <span>
#include <string>
#include <vector>

#include <contact/convex_hull.hpp>
#include <contact/convex_shapes.hpp>
#include <contact/coordinate_range.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/oriented_box.hpp>
#include <contact/ray_cylinder.hpp>
#include <contact/ray_kdop.hpp>
#include <contact/shapes.hpp>
#include <contact/slab_facets.hpp>
#include <contact/vector.hpp>

namespace contact {

// [convex-bodies]
/// A lozenge: all points at most radius from the parallelogram corner + x first edge + y second
/// edge, with x and y from 0 to 1. With edges at a right angle it is the sum of a rectangle and a
/// ball (rectangle swept sphere).
///
/// Edges may be 0 or parallel: then the core is a segment or a point.
/// @see Larsen, Gottschalk, Lin and Manocha, *Fast Proximity Queries with Swept Sphere Volumes*,
/// University of North Carolina, TR99-018 (1999)
template <Ring S>
struct Lozenge {
  Vector3<S> corner = Vector3<S>::Zero();       ///< m
  Vector3<S> first_edge = Vector3<S>::Zero();   ///< m
  Vector3<S> second_edge = Vector3<S>::Zero();  ///< m
  S radius = S(0);                              ///< m, not negative
};

/// An ellipsoid: all points centre + Σ xᵢ half lengthᵢ axesᵢ with |x| ≤ 1.
///
/// The stored body is this image of the unit ball, also if rounding has made the axes oblique: then
/// it is an ellipsoid whose principal axes are slightly different ones.
template <Ring S>
struct Ellipsoid {
  Vector3<S> centre = Vector3<S>::Zero();        ///< m
  Matrix3<S> axes = Matrix3<S>::Identity();      ///< columns in world coordinates
  Vector3<S> half_lengths = Vector3<S>::Zero();  ///< along each axis, m, greater than 0
};

/// The convex hull of points, or all points at most radius from it.
///
/// Points that are not vertices of the hull cost time and change no answer.
template <Ring S>
struct ConvexHull {
  std::vector<Vector3<S>> vertices;  ///< n ≥ 1, m
  S radius = S(0);                   ///< m, not negative
};
// [/convex-bodies]

/// A lozenge from input.
/// @param corner of the parallelogram, m
/// @param first_edge, second_edge from the corner, m; they may be 0, parallel or oblique
/// @param radius m, not negative
/// @throws std::invalid_argument naming the argument and its value, also if it is out of range
template <FloatOrDouble S>
Lozenge<S> lozenge_from_edges(const Vector3<S>& corner, const Vector3<S>& first_edge,
                              const Vector3<S>& second_edge, const S& radius) {
  detail::require_position("corner", corner);
  detail::require_position("first_edge", first_edge);
  detail::require_position("second_edge", second_edge);
  detail::require_extent("radius", radius, false);
  return {corner, first_edge, second_edge, radius};
}

/// An ellipsoid from input.
/// @param axes a rotation: columns of length 1, orthogonal to within 64 u, right-handed
/// @param half_lengths m, each greater than 0
/// @throws std::invalid_argument naming the argument and its value, also if it is out of range
template <FloatOrDouble S>
Ellipsoid<S> ellipsoid_from_axes(const Vector3<S>& centre, const Matrix3<S>& axes,
                                 const Vector3<S>& half_lengths) {
  const OrientedBox<S> around = oriented_box_from_axes<S>(centre, axes, half_lengths);
  return {around.centre, around.axes, around.half_lengths};
}

/// A solid cylinder from input.
/// @param start, end of the core, m; they must differ, because equal ends have no direction
/// @param radius m, not negative
/// @throws std::invalid_argument naming the argument and its value, also if it is out of range
template <FloatOrDouble S>
Cylinder<S> cylinder_from_segment(const Vector3<S>& start, const Vector3<S>& end, const S& radius) {
  detail::require_position("start", start);
  detail::require_position("end", end);
  detail::require_extent("radius", radius, false);
  if (start == end) throw_invalid_argument("end", vector_text(end), "must differ from the start");
  return {{start, end}, radius};
}

/// The convex hull of points as a body: with the vertices of the hull alone, which are found
/// exactly.
/// @param points n ≥ 1, m
/// @param radius m, not negative
/// @throws std::invalid_argument naming the argument and its value, also if it is out of range
template <FloatOrDouble S>
ConvexHull<S> convex_hull_from_points(std::span<const Vector3<S>> points, const S& radius = S(0)) {
  if (points.empty()) throw_invalid_argument("points", "{}", "there must be at least one point");
  detail::require_extent("radius", radius, false);
  std::vector<Vector3<double>> in_double;
  in_double.reserve(points.size());
  for (const Vector3<S>& point : points) {
    detail::require_position("points", point);
    in_double.push_back(point.template cast<double>());
  }
  ConvexHull<S> body;
  body.radius = radius;
  for (const int i : convex_hull(in_double).vertices) {
    body.vertices.push_back(points[static_cast<std::size_t>(i)]);
  }
  return body;
}

/// A k-DOP as a body: the hull of its vertices.
///
/// Limits: the vertices are rounded (see kdop_facets()), so the hull is not exactly the k-DOP: it
/// neither contains it nor is it contained in it. What is decided about it is decided about the
/// stored vertices.
/// @param radius m, not negative
/// @throws std::invalid_argument if kdop_vertices() finds none, because the k-DOP is empty, without
/// an end, a point or a segment; or if an argument is out of range
template <FloatOrDouble S>
ConvexHull<S> convex_hull_from_kdop(const Kdop<S>& dop, const S& radius = S(0)) {
  const std::vector<Vector3<double>> corners = kdop_vertices(dop);
  if (corners.empty()) {
    throw_invalid_argument("dop", std::to_string(dop.normals.size()) + " slabs",
                           "must be bounded and have a facet");
  }
  std::vector<Vector3<S>> points;
  points.reserve(corners.size());
  for (const Vector3<double>& corner : corners) points.push_back(corner.template cast<S>());
  return convex_hull_from_points<S>(points, radius);
}

}  // namespace contact
