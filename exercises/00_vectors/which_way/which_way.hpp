/// @file
/// Exercise: does a path turn left or right?
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// Which way a path turns that goes straight from a to b, and then straight to c: +1 to the left,
/// −1 to the right, 0 if it does not turn, or turns back on itself, or if two of the points that
/// follow one another are the same.
///
/// Seen with x to the right and y up. Size and place do not matter: steps of a micrometre turn like
/// steps of a kilometre, and a path far from the origin like one near it, as long as the
/// differences of the coordinates, and their products, need no more than the digits of a double.
///
/// @param a m
/// @param b m
/// @param c m
int which_way(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c);

}  // namespace exercise
