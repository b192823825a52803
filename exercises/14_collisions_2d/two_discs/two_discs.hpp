/// @file
/// Exercise: the collision of two smooth discs in contact.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A disc without friction.
struct Disc {
  double mass;               ///< kg, greater than 0
  Eigen::Vector2d centre;    ///< m
  Eigen::Vector2d velocity;  ///< m/s
};

/// The velocities of two discs.
struct Velocities {
  Eigen::Vector2d a;  ///< m/s
  Eigen::Vector2d b;  ///< m/s
};

/// Whether two discs approach: whether the distance of their centres decreases. Discs that
/// separate, whose distance is stationary, or whose centres coincide do not approach.
bool approach(const Disc& a, const Disc& b);

/// The velocities of two discs in contact after their collision.
///
/// Along the line of centres they collide with the given coefficient of restitution; the tangential
/// components do not change. Discs that do not approach() keep their velocities.
///
/// @param a, b two discs in contact
/// @param restitution e, from 0 to 1: the separation speed along the line of centres is e times the
/// approach speed
Velocities after_touch(const Disc& a, const Disc& b, double restitution);

}  // namespace exercise
