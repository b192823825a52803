/// @file
/// Exercise: on which side of a plane, and how far from it.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// The plane of all (x, y, z) with a·x + b·y + c·z + d = 0. The vector (a, b, c) has any length but
/// zero; it points to the front.
struct PlaneEquation {
  double a, b, c, d;
};

/// How far the point is from the plane, in metres: positive in front, negative behind, 0 on it.
///
/// @param plane coefficients of any scale: twice the coefficients are the same plane
/// @param point m
double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point);

/// On which side of the plane the point is: 1 in front, -1 behind, 0 on it.
///
/// However near the plane a point is, it is on the plane only if a·x + b·y + c·z + d is zero.
int side(const PlaneEquation& plane, const Eigen::Vector3d& point);

}  // namespace exercise
