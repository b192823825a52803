/// @file
/// Exercise: where a ray meets a triangle.
#pragma once

#include <contact/prelude.hpp>

#include <contact/shapes.hpp>

namespace exercise {

/// Where the ray meets the triangle, or nothing if it misses.
///
/// The hit holds `t`, the place on the ray (origin + t·direction, t ≥ 0, in lengths of the
/// direction as given), and `barycentric`, the weights of the corners a, b and c in that order:
/// they are not negative, their sum is 1, and weighted with them the corners add up to the point of
/// the hit.
///
/// - Touching counts: a hit on an edge, on a corner, or at the origin itself (t = 0) is a hit.
/// - Both sides of the triangle can be hit.
/// - A ray in a parallel plane, or in the plane of the triangle, has no single point of hit:
///   nothing. The same holds for a direction of length zero and for a triangle without area.
/// - Size does not matter: a triangle a micrometre wide is hit like one a kilometre wide.
///
/// @param ray origin in m; direction of any length but finite, in m for each unit of t
/// @param triangle corners in m
std::optional<contact::TriangleHit<double>> ray_triangle(const contact::Ray<double>& ray,
                                                         const contact::Triangle<double>& triangle);

}  // namespace exercise
