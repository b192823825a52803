/// @file
/// Exercise: vectors whose angle the arccosine loses.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// Two vectors, in any unit.
struct Pair {
  Eigen::Vector3d u;  ///< not zero
  Eigen::Vector3d v;  ///< not zero
};

/// Vectors for which given::angle_by_acos returns NaN. Every coordinate is from -1 to 1, and the
/// vectors are at least 0.1 long.
Pair angle_is_no_number();

/// Vectors that are not parallel, and whose angle given::angle_by_acos gets wrong by more than 1 %.
/// Every coordinate is a whole number from -1,000,000 to 1,000,000.
Pair angle_is_lost();

/// Vectors whose angle is at least 0.5 rad and at most 2.5 rad, and for which given::angle_by_acos
/// is wrong by more than 1 %. Every coordinate is finite.
Pair large_angle();

}  // namespace exercise
