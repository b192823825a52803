/// @file
/// Exercise: point in polygon by counting crossings.
///
/// All numbers are whole, from -2^25 to 2^25, so that a double holds every difference, every
/// product of two of them and the difference of two such products without rounding: the answers
/// must be right for every input.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// Whether the ray from the point in the direction of +x crosses the edge.
///
/// It does if one end of the edge is above the ray and the other is not, and the edge crosses the
/// ray's line to the right of the point. An end level with the point is not above, so a horizontal
/// edge is never crossed.
///
/// @param point not on the edge
/// @param from, to the ends of the edge
bool crosses(const Eigen::Vector2d& point, const Eigen::Vector2d& from, const Eigen::Vector2d& to);

/// Whether the point is inside the polygon by the even-odd rule: the ray crosses an odd number of
/// edges.
///
/// @param polygon at least 3 vertices, in either orientation; it may be concave and cross itself.
///   The last edge goes from the last vertex to the first
/// @param point not on an edge
bool crossings(const std::vector<Eigen::Vector2d>& polygon, const Eigen::Vector2d& point);

}  // namespace exercise
