/// @file
/// Exercise: from three dimensions to two, and point in triangle.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// The dimension (0 for x, 1 for y, 2 for z) to leave out when points of a plane are projected to
/// two dimensions: the one along which the projection of a triangle in that plane has the largest
/// area. If several are equally good, any of them.
///
/// @param normal of the plane; not zero, of any length
int dropped_dimension(const Eigen::Vector3d& normal);

/// Whether the point is in the triangle a, b, c, edges and vertices included.
///
/// The vertices may have either orientation. A triangle without area contains nothing.
///
/// @param point, a, b, c in m
bool point_in_triangle(const Eigen::Vector2d& point, const Eigen::Vector2d& a,
                       const Eigen::Vector2d& b, const Eigen::Vector2d& c);

}  // namespace exercise
