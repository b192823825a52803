/// @file
/// Exercise: the first body that a bullet meets.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A solid ball: all points at most radius from centre.
struct Ball {
  Eigen::Vector3d centre;  ///< m
  double radius;           ///< positive, m
};

/// A solid box: all points x with low ≤ x ≤ high in each coordinate. It may be flat.
struct Box {
  Eigen::Vector3d low;   ///< m
  Eigen::Vector3d high;  ///< m
};

/// A body that moves without rotating.
struct Body {
  std::variant<Ball, Box> shape;  ///< where it is at the beginning of the step
  Eigen::Vector3d displacement;   ///< by how much it moves in the step, m
};

/// The body of a list that is met first.
struct FirstHit {
  int index;  ///< the first body of the list has index 0
  double t;   ///< the fraction of the step before it, from 0 to 1
};

/// The body that a bullet meets first in one step of a simulation. Nothing, if it meets none.
///
/// The bullet is a point. In the step it moves from one point to another, and each body moves by
/// its displacement, all of them along straight lines and at constant speeds. Bodies do not hinder
/// each other.
///
/// - Touching counts, also at the very beginning or end of the step.
/// - A bullet that is in a body at the beginning meets it at t = 0.
/// - If several bodies are met at the same t, it is the one that is first in the list.
///
/// @param from where the bullet is at the beginning, m
/// @param to where it would be at the end if it met nothing; may be the same as from, m
std::optional<FirstHit> first_in_scene(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                       const std::vector<Body>& bodies);

}  // namespace exercise
