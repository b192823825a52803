/// @file
/// Exercise: pairs of triangles for which an overlap of intervals is wrong.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// Two triangles, in m: a, b, c and p, q, r. Each has an area.
struct Pair {
  Eigen::Vector3d a;
  Eigen::Vector3d b;
  Eigen::Vector3d c;
  Eigen::Vector3d p;
  Eigen::Vector3d q;
  Eigen::Vector3d r;
};

/// Triangles with a common point that given::triangles_meet says are apart. They are not in one
/// plane, and all coordinates are whole numbers from -10 to 10.
Pair common_point_missed();

/// Triangles that given::triangles_meet says meet, although in one of the coordinates they are
/// apart by at least 0.005: the largest of the one triangle is so much less than the smallest of
/// the other. No edge is shorter than 0.005, and no coordinate is larger than 1.
Pair gap_missed();

/// Triangles in one plane, p, q, r inside a, b, c without touching its edges, that
/// given::triangles_meet says are apart. All coordinates are whole numbers from -10000000 to
/// 10000000.
Pair inside_missed();

}  // namespace exercise
