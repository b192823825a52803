/// @file
/// Exercise: the vertices of a hull in the plane.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// The vertices of the convex hull, by index, counter-clockwise. The first is the one with the
/// least x, and of those the one with the least y.
///
/// - A point on an edge, between two vertices, is no vertex.
/// - Of equal points only the first can be a vertex.
/// - No points give no vertices, points that are all equal give one, and points on one line give
///   the two ends.
///
/// @param points whole numbers from -2^25 to 2^25; any number of points
std::vector<int> hull_2d(const std::vector<Eigen::Vector2d>& points);

}  // namespace exercise
