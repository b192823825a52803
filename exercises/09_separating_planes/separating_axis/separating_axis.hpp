/// @file
/// Exercise: a direction that separates two convex polygons, or none.
///
/// A polygon is the list of its vertices, counter-clockwise and convex: no vertex is repeated, and
/// no three are on one line. A list of two vertices is a segment, and of one vertex a point. The
/// edges belong to the polygon, and so does its inside. Coordinates are whole numbers from -1000000
/// to 1000000, in m. A double holds all dot products of a vertex and a difference of two vertices
/// without rounding, so each answer must be right.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// Whether the polygons are apart along a direction n, and the first one comes before the second:
/// n · p < n · q for all points p of the first and q of the second.
///
/// Polygons that touch have a point in common, so no direction separates them.
///
/// @param direction of any length, perhaps zero; whole numbers from -2000000 to 2000000
/// @param first at least one vertex
/// @param second at least one vertex
bool separates(const Eigen::Vector2d& direction, const std::vector<Eigen::Vector2d>& first,
               const std::vector<Eigen::Vector2d>& second);

/// A direction that separates the first polygon from the second, in this order, or nothing if they
/// have a point in common.
///
/// Every such direction is right, of any length. Of the numbers that are returned n · p < n · q
/// holds for all vertices, without rounding.
///
/// @param first at least one vertex
/// @param second at least one vertex
std::optional<Eigen::Vector2d> separating_axis(const std::vector<Eigen::Vector2d>& first,
                                               const std::vector<Eigen::Vector2d>& second);

}  // namespace exercise
