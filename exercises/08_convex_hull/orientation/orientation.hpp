/// @file
/// Exercise: does the path turn left, turn right, or go straight on?
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// The orientation of three points: +1 if the path from a over b to c turns left (c is left of the
/// line from a to b), -1 if it turns right, 0 if the three points are collinear or two of them are
/// equal.
///
/// The sign must be right for every input: nearly collinear points are not collinear.
///
/// @param a,b,c whole numbers from -2^25 to 2^25, so that a double holds every difference, every
///   product of two of them and the difference of two such products without rounding
int orientation(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c);

}  // namespace exercise
