/// @file
/// Exercise: the proof that two bodies cannot pass through each other within a step (tunnelling).
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// Bounds on a body's motion in a step. Directions are not known.
struct Mover {
  double speed;             ///< at most, of its centre at the beginning of the step, m/s
  double acceleration;      ///< at most, of its centre during the step, m/s²
  double bounding_radius;   ///< bounding radius: at most, from its centre to its surface, m
  double angular_velocity;  ///< angular speed: at most, during the step, rad/s
};

/// What is proven for a step.
struct Proof {
  double displacement;  ///< no two points approach each other by more, m
  bool nothing_passes;  ///< whether that proves that nothing passes through undetected
};

/// Whether two bodies can pass through each other in a step without being detected.
///
/// The displacement is the largest possible path length of a point of A in the step plus that of a
/// point of B. Without directions no smaller bound is valid.
///
/// The program tests for contact at the beginning and at the end of the step, and bodies that just
/// touch are in contact. To pass through each other and touch at neither test, the two must
/// approach each other by more than `thickness`. So a displacement of exactly `thickness` is proof
/// enough.
///
/// @param a, b the two; no number is negative
/// @param step s, greater than 0
/// @param thickness m, greater than 0
Proof prove(const Mover& a, const Mover& b, double step, double thickness);

}  // namespace exercise
