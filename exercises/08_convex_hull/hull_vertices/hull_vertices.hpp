/// @file
/// Exercise: which points are vertices of their hull in space?
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// The indices of the points that are vertices of the convex hull of all points, in increasing
/// order.
///
/// A point is a vertex if it is not in the hull of the points that differ from it. So a point on an
/// edge or inside a face is no vertex. Of equal points only the first can be a vertex. The points
/// may be coplanar, collinear or all equal: their polygon, segment or point has vertices too.
///
/// @param points whole numbers from -1000 to 1000; at most 20 points
std::vector<int> hull_vertices(const std::vector<Eigen::Vector3d>& points);

}  // namespace exercise
