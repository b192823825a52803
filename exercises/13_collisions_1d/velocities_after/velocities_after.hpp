/// @file
/// Exercise: two bodies collide on a line.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

struct Body {
  double mass;      ///< kg
  double velocity;  ///< m/s
};

/// The velocities after a collision, in m/s.
struct After {
  double first;
  double second;
};

/// The velocities of two touching bodies after they have collided. If they do not approach there is
/// no collision, and they keep their velocities. No external force acts.
///
/// It throws std::invalid_argument if a mass is not greater than 0, or if the coefficient of
/// restitution is not from 0 to 1.
/// @param first the body on the left; to the right is positive
/// @param second the body on the right
/// @param restitution speed of separation over closing speed
After collide(const Body& first, const Body& second, double restitution);

}  // namespace exercise
