/// @file
/// Exercise: where a ray meets a triangle.
#pragma once

#include <contact/prelude.hpp>

#include <contact/shapes.hpp>

namespace exercise {

/// Where the ray meets the triangle, or nothing if it misses.
///
/// The hit holds `t`, the parameter on the ray (origin + t·direction, t ≥ 0, in multiples of the
/// direction as given), and `barycentric`, the weights of the vertices a, b and c in that order:
/// they are not negative, their sum is 1, and the weighted sum of the vertices is the point of the
/// hit.
///
/// - Touching counts: on an edge, at a vertex, or at the origin itself (t = 0).
/// - Both sides of the triangle can be hit.
/// - A ray parallel to the plane of the triangle, or in it, has no single meeting point: nothing.
///   The same holds for a zero direction and for a triangle without area.
/// - Size does not matter, from micrometres to kilometres.
///
/// @param ray origin in m; direction of any length but finite, in m for each unit of t
/// @param triangle vertices in m
std::optional<contact::TriangleHit<double>> ray_triangle(const contact::Ray<double>& ray,
                                                         const contact::Triangle<double>& triangle);

}  // namespace exercise
