/// @file
/// Exercise: the kinetic energy that a collision loses.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

struct Body {
  double mass;      ///< kg, greater than 0
  double velocity;  ///< m/s
};

struct EnergyLoss {
  double lost;      ///< total kinetic energy before minus that after, J
  double fraction;  ///< the loss divided by the total kinetic energy before; 0 if that was 0
};

/// The kinetic energy that a collision on a line loses. If the bodies do not approach, there is no
/// collision and no loss. The *relative* error must be small, also for a small closing speed of two
/// fast bodies.
///
/// @param first the body on the left; to the right is positive
/// @param second the body on the right
/// @param restitution speed of separation over closing speed, from 0 to 1
EnergyLoss energy_loss(const Body& first, const Body& second, double restitution);

}  // namespace exercise
