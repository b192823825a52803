/// @file
/// Exercise: the kinetic energy that a collision costs.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

struct Body {
  double mass;      ///< kg, greater than 0
  double velocity;  ///< m/s
};

struct Bill {
  double lost;      ///< kinetic energy of both before, less that after, J
  double fraction;  ///< what part of the kinetic energy before that is; 0 if there was none
};

/// What a collision on a line costs. If the bodies do not approach there is none, and it costs
/// nothing. The answer has a small *relative* error, also if the bodies fly fast and meet gently.
///
/// @param first the body on the left; to the right is positive
/// @param second the body on the right
/// @param restitution speed of separation over closing speed, from 0 to 1
Bill bill(const Body& first, const Body& second, double restitution);

}  // namespace exercise
