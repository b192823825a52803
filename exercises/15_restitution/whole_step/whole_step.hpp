/// @file
/// Exercise: one time step of a bouncing ball that comes to rest, with every impact in it.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A ball above a level floor.
struct Ball {
  double height = 0;     ///< of its lowest point, m, not negative
  double velocity = 0;   ///< upwards, m/s
  int bounces = 0;       ///< impacts so far
  bool resting = false;  ///< if true, height and velocity are 0
};

/// The ball one step later. Between impacts it falls freely; at an impact it leaves the floor with
/// k times the speed with which it came. If it would leave at rest_speed or less, it rests from
/// then on; that impact counts too. A step may contain many impacts, or none. An impact exactly at
/// the end of the step belongs to it.
///
/// @param ball at the start of the step; a resting ball is returned unchanged; a ball on the floor
/// that does not rest is given with a velocity above 0
/// @param gravity m/s², greater than 0
/// @param k coefficient of restitution, 0 to 1
/// @param rest_speed m/s, greater than 0
/// @param step s, greater than 0
Ball whole_step(const Ball& ball, double gravity, double k, double rest_speed, double step);

}  // namespace exercise
