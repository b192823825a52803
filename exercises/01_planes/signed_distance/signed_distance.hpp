/// @file
/// Exercise: the side and the signed distance of a point.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// The plane of all (x, y, z) with a·x + b·y + c·z + d = 0. The vector (a, b, c) has any length but
/// zero; it points to the front.
struct PlaneEquation {
  double a, b, c, d;
};

/// The signed distance of the point from the plane, in m: positive in front, negative behind, 0 on
/// it.
///
/// @param plane coefficients of any scale: twice the coefficients give the same plane
/// @param point m
double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point);

/// The side of the plane on which the point is: 1 in front, -1 behind, 0 on it.
///
/// A point is on the plane only if a·x + b·y + c·z + d is zero, however small the distance.
int side(const PlaneEquation& plane, const Eigen::Vector3d& point);

}  // namespace exercise
