/// @file
/// Exercise: roll back to the last time at which a falling ball does not overlap the floor.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A ball above a horizontal floor.
struct Ball {
  double height;    ///< of its lowest point, m, greater than 0
  double velocity;  ///< upwards, m/s
};

/// The height of the ball after the time t without a floor: height + velocity t − gravity t²/2. The
/// ball is free of the floor if that is 0 or more.
///
/// @param ball at the start of the step
/// @param gravity m/s², greater than 0
/// @param t s, 0 or more
double height_at(const Ball& ball, double gravity, double t);

/// A time in the step, s, at which the ball is free, less than `tolerance` before the impact; or
/// the end of the step, if the ball is free there. By bisection or otherwise.
///
/// @param ball, gravity as above
/// @param step s, greater than 0; a ball that is free at the end of the step is free throughout
/// @param tolerance s, greater than 0 and not below 10⁻⁹ of the step
double last_free(const Ball& ball, double gravity, double step, double tolerance);

}  // namespace exercise
