/// @file
/// Exercise: steps that pass a test for tunnelling and should not.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A body and a wall in one step, as nothing_passes has them.
struct Step {
  double speed;             ///< of the body's centre at the beginning of the step, m/s
  double acceleration;      ///< at most, of its centre, m/s^2
  double bounding_radius;   ///< from its centre to its farthest point, m
  double angular_velocity;  ///< at most, rad/s
  double wall_speed;        ///< at most, m/s
  double duration;          ///< of the step, s, at most 1/60 (0.0167)
  double thickness;         ///< of the wall, m, at least 0.05
};

/// A step that is not safe although given::slow_enough says so. Body and wall are at rest at the
/// beginning, and nothing rotates.
///
/// Like all steps here: no number is negative or larger than 1000, the duration is at most 0.0167
/// s, and the thickness is at least 0.05 m. A step is safe if no two points can approach each other
/// by more than the thickness.
Step starts_at_rest();

/// The same, of a step in which nothing accelerates or rotates.
Step nothing_accelerates();

/// The same, of a step in which the centre of the body and the wall stay at rest.
Step centre_at_rest();

}  // namespace exercise
