/// @file
/// Exercise: which points are corners of their hull in space?
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// The indices of the points that are corners of the convex hull of all points, in increasing
/// order.
///
/// A point is a corner if it is not in the hull of the others. So a point on an edge or within a
/// face is none. Of equal points only the first can be a corner. The points may lie in one plane,
/// on one line, or all in one place: their polygon, segment or point has corners too.
///
/// @param points whole numbers from -1000 to 1000; at most 20 points
std::vector<int> hull_corners(const std::vector<Eigen::Vector3d>& points);

}  // namespace exercise
