/// @file
/// Exercise: point in a convex polygon by edge tests.
///
/// All numbers are whole, from -2^25 to 2^25, so that a double holds every difference, every
/// product of two of them and the sum of two such products without rounding: the answers must be
/// right for every input.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// Where a point is of a polygon.
enum class Where { outside, on, inside };

/// The outward normal of an edge of a counter-clockwise polygon: perpendicular to the edge, as long
/// as the edge, and pointing out of the polygon.
///
/// @param from, to the ends of the edge, in the order of the polygon; different from each other
Eigen::Vector2d outward_normal(const Eigen::Vector2d& from, const Eigen::Vector2d& to);

/// The dot product of this normal and the vector from the edge to the point: positive in front of
/// the edge, zero on its line, negative behind it.
///
/// @param point anywhere
/// @param from, to the ends of the edge, as for the normal
double ahead(const Eigen::Vector2d& point, const Eigen::Vector2d& from, const Eigen::Vector2d& to);

/// Where the point is of a convex polygon: `on` is on an edge or at a vertex.
///
/// @param polygon at least 3 vertices, counter-clockwise, no two equal; the last edge goes from the
///   last vertex to the first. Neighbouring edges may be on one line, but not all of them
/// @param point anywhere
Where edge_tests(const std::vector<Eigen::Vector2d>& polygon, const Eigen::Vector2d& point);

}  // namespace exercise
