/// @file
/// Exercise: two smooth discs that touch, and how they leave.
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

/// Whether the centres of two discs come closer. If they go apart, or their distance does not
/// change at that moment, they do not approach; nor do discs whose centres coincide.
bool approach(const Disc& a, const Disc& b);

/// The velocities of two discs after they have touched.
///
/// Along the line of centres they collide with the coefficient of restitution given; across it
/// nothing pushes. Discs that do not approach() keep their velocities.
///
/// @param a, b two discs that touch
/// @param restitution e, from 0 to 1: along the line of centres they part e times as fast as they
/// approached
Velocities after_touch(const Disc& a, const Disc& b, double restitution);

}  // namespace exercise
