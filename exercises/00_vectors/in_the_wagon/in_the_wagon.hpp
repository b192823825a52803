/// @file
/// Exercise: places and velocities in the frame of a wagon.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A wagon on a plain, seen from above; the world's x points right and its y up.
struct Wagon {
  Eigen::Vector2d position;  ///< of its origin, in the world, m
  Eigen::Vector2d forward;   ///< where it looks, in the world: a unit vector
};

/// Where a place of the world is in the wagon's frame, in m: x′ counts ahead, y′ to the left.
Eigen::Vector2d place_in_wagon(const Wagon& wagon, const Eigen::Vector2d& place);

/// A velocity of the world in the wagon's axes, in m/s: x′ ahead, y′ to the left. The wagon stands
/// still.
Eigen::Vector2d velocity_in_wagon(const Wagon& wagon, const Eigen::Vector2d& velocity);

/// Where a place that is known in the wagon's frame is in the world, in m.
Eigen::Vector2d place_in_world(const Wagon& wagon, const Eigen::Vector2d& place_in_wagon);

}  // namespace exercise
