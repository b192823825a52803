/// @file
/// Exercise: does a path turn left or right?
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// The turn at b of a path that goes straight from a to b, and then straight to c: +1 to the left,
/// −1 to the right, 0 if it goes straight on or reverses, or if two successive points are the same.
///
/// x points right and y up. Size and position do not matter, from micrometres to kilometres and far
/// from the origin, as long as the differences of the coordinates, and the products of these, are
/// exact in double precision.
///
/// @param a m
/// @param b m
/// @param c m
int orientation_sign(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c);

}  // namespace exercise
