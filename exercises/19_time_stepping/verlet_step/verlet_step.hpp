/// @file
/// Exercise: Verlet's step of a body on a spring.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A body on a spring that pulls it to 0 with the acceleration −ω² x.
struct Swinging {
  double position;  ///< x, m
  double velocity;  ///< m/s
};

/// One step of Verlet's by the velocity: half of the step's push with the force of where the body
/// is, then the whole way, then the other half of the push with the force of where it has come to.
///
/// @param body at the start of the step
/// @param angular_frequency ω, rad/s, greater than 0
/// @param step s, greater than 0
Swinging verlet_step(const Swinging& body, double angular_frequency, double step);

}  // namespace exercise
