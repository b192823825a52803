/// @file
/// Exercise: pairs of boxes for which a separating axis test with an epsilon is wrong.
///
/// Fifteen directions decide whether two boxes are apart: the normals of the faces of each, and the
/// cross products of an edge of one and an edge of the other. Boxes are apart by d along one of
/// them if two planes perpendicular to it, with the distance d from each other, have the boxes on
/// their outer sides.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// Two boxes A and B: all points centre + x u + y v + z w with x, y and z from -1 to 1, in m. So
/// the edges of a box are twice as long as its u, v and w. These three are perpendicular to one
/// another: the cosine of their angle is at most 1e-9.
struct Pair {
  Eigen::Vector3d centre_a;
  Eigen::Vector3d u_a;
  Eigen::Vector3d v_a;
  Eigen::Vector3d w_a;
  Eigen::Vector3d centre_b;
  Eigen::Vector3d u_b;
  Eigen::Vector3d v_b;
  Eigen::Vector3d w_b;
};

/// Boxes that given::meet_skipping says meet, although they are apart by at least 0.001 along one
/// of the fifteen directions. Their u, v and w have lengths from 0.01 to 0.05, and no coordinate of
/// a centre is beyond 10.
Pair small_gap_missed();

/// Boxes that given::meet_padded says meet, although they are apart by at least 0.001 along one of
/// the fifteen directions. Their u, v and w have lengths from 0.1 to 1, and no coordinate of a
/// centre is beyond 10.
Pair padded_gap_missed();

/// Boxes with a common point that given::meet_skipping says are apart. All coordinates, also those
/// of u, v and w, are whole numbers from -10000000 to 10000000. None of u, v and w is zero, and
/// they are exactly perpendicular to one another.
Pair common_point_missed();

}  // namespace exercise
