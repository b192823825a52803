/// @file
/// Code to break: whether a body is too slow to pass through a wall in a step.
#pragma once

#include <contact/prelude.hpp>

namespace given {

/// Whether a body is slow enough that it cannot pass through a wall between two tests.
///
/// @param speed of the body, m/s
/// @param duration of the step, s
/// @param thickness of the wall, m
inline bool slow_enough(double speed, double duration, double thickness) {
  return speed * duration <= thickness;
}

}  // namespace given
