/// @file
/// Exercise: the kind of a collision, from measured velocities.
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
  passed_through,  ///< they still approach, which no collision does
  together,        ///< perfectly inelastic: they leave at one velocity
  inelastic,       ///< kinetic energy is lost, and they separate
  elastic,         ///< no kinetic energy is lost
  energy_gained    ///< more kinetic energy than before, as in an explosion
};

struct Report {
  double first_after;  ///< velocity of the first afterwards, m/s
  double restitution;  ///< coefficient of restitution
  Kind kind;
};

/// The outcome of a collision after which the second body's velocity is known. No external force
/// acts.
///
/// @param before the two bodies
/// @param second_after velocity of the second afterwards, m/s
Report report(const Before& before, double second_after);

}  // namespace exercise
