/// @file
/// Exercise: a step of velocity Verlet for a body on a spring.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A body on a spring, with the acceleration −ω² x.
struct Swinging {
  double position;  ///< x, m
  double velocity;  ///< m/s
};

/// One step of velocity Verlet: the velocity for half a step with the acceleration at the old
/// position, the position for a whole step, the velocity for half a step with the acceleration at
/// the new position.
///
/// @param body at the start of the step
/// @param angular_frequency ω, rad/s, greater than 0
/// @param step s, greater than 0
Swinging verlet_step(const Swinging& body, double angular_frequency, double step);

}  // namespace exercise
