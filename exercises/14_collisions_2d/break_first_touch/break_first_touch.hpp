/// @file
/// Exercise: discs whose first touch a quadratic formula gets wrong.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// Two discs, as one sees the other.
struct Approach {
  Eigen::Vector2d position;  ///< of the centre of B relative to that of A, m
  Eigen::Vector2d velocity;  ///< of B relative to A, m/s, not zero
  double radii;              ///< the sum of the radii, m, greater than 0
};

/// Discs that overlap and approach, so that they touch at time 0, and of which given::time_of_touch
/// says otherwise. Like all numbers here, none is larger than 1e9, and the sum of the radii is at
/// least 0.001 m.
Approach overlapping();

/// Discs that do not overlap and touch later, at a time that given::time_of_touch gets wrong by
/// more than 1 %.
Approach time_is_wrong();

/// Discs that approach each other head-on along the x axis, and of which given::time_of_touch says
/// that they never touch. The y components are zero, and the discs do not overlap.
Approach head_on();

}  // namespace exercise
