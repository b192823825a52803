/// @file
/// Exercise: what kind of collision it was, from what was measured.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// Two bodies on a line before they collide. The first is on the left, and to the right is
/// positive.
struct Before {
  double first_mass;       ///< kg, greater than 0
  double first_velocity;   ///< m/s, greater than second_velocity
  double second_mass;      ///< kg, greater than 0
  double second_velocity;  ///< m/s
};

enum class Kind {
  passed_through,  ///< they still approach: no collision does that
  together,        ///< perfectly inelastic: they leave at one velocity
  inelastic,       ///< kinetic energy is lost, and they part
  elastic,         ///< no kinetic energy is lost
  energy_gained    ///< more kinetic energy than before: something has gone off
};

struct Report {
  double first_after;  ///< velocity of the first afterwards, m/s
  double restitution;  ///< coefficient of restitution
  Kind kind;
};

/// What happened in a collision of which the second body's velocity afterwards is known. No force
/// acts from outside.
///
/// @param before the two bodies
/// @param second_after velocity of the second afterwards, m/s
Report report(const Before& before, double second_after);

}  // namespace exercise
