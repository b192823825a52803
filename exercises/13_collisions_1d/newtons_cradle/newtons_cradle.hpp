/// @file
/// Exercise: a row of balls that touch.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

struct Ball {
  double mass;      ///< kg, greater than 0
  double velocity;  ///< m/s
};

/// The velocities of all balls, in m/s, when no neighbours approach any more.
///
/// Each ball touches its neighbours. Of all pairs of neighbours that approach, the pair with the
/// largest closing speed collides elastically; of equal ones the leftmost. This is repeated.
/// @param row from left to right; to the right is positive. At most 12 balls, perhaps none
std::vector<double> settled(const std::vector<Ball>& row);

}  // namespace exercise
