/// @file
/// Code to break: a step of a point between two walls.
#pragma once

#include <contact/prelude.hpp>

namespace given {

/// The position after a step of a point that moves freely between walls at 0 m and 1 m, from which
/// it rebounds with k = 1.
inline double reflect_once(double position, double velocity, double duration) {
  double after = position + velocity * duration;
  if (after > 1) after = 2 - after;
  if (after < 0) after = -after;
  return after;
}

}  // namespace given
