/// @file
/// Exercise: positions and velocities in the frame of a wagon.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A wagon on a plain, seen from above; the world's x points right and its y up.
struct Wagon {
  Eigen::Vector2d position;  ///< of its origin, in the world, m
  Eigen::Vector2d forward;   ///< the direction in which it faces, in the world: a unit vector
};

/// The coordinates in the wagon's frame of a position in the world, in m: x′ is ahead, y′ to the
/// left.
Eigen::Vector2d position_in_wagon(const Wagon& wagon, const Eigen::Vector2d& position);

/// The coordinates in the wagon's axes of a velocity in the world, in m/s: x′ is ahead, y′ to the
/// left. The wagon is at rest.
Eigen::Vector2d velocity_in_wagon(const Wagon& wagon, const Eigen::Vector2d& velocity);

/// The world coordinates of a position given in the wagon's frame, in m.
Eigen::Vector2d position_in_world(const Wagon& wagon, const Eigen::Vector2d& position_in_wagon);

}  // namespace exercise
