/// @file
/// Exercise: the proof that two bodies cannot pass through each other between two looks.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// What is known of a body before a step. Directions are not known.
struct Mover {
  double speed;         ///< of its centre at the beginning of the step, at most, m/s
  double acceleration;  ///< of its centre during the step, at most, m/s²
  double reach;         ///< of its surface from its centre, at most, m
  double spin;          ///< during the step, at most, rad/s
};

/// What is proven for a step.
struct Proof {
  double displacement;  ///< no two points come farther towards each other, m
  bool nothing_passes;  ///< whether that proves that nothing passes through unseen
};

/// Whether two bodies can pass through each other in a step and not be seen to touch.
///
/// The displacement asked for is the greatest length of the path of a point of A and of the path of
/// a point of B in the step, both together: no less can be proven, and no more is needed.
///
/// The program looks for contact at the beginning and at the end of the step, and bodies that just
/// touch are in contact. To pass from one side of each other to the other, and touch at neither
/// look, the two must move by more than `thickness` towards each other.
///
/// @param a, b the two; no number is negative
/// @param step s, greater than 0
/// @param thickness m, greater than 0
Proof prove(const Mover& a, const Mover& b, double step, double thickness);

}  // namespace exercise
