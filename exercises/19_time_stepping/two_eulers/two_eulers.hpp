/// @file
/// Exercise: a step of explicit Euler and a step of symplectic Euler.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A body that falls.
struct Body {
  Eigen::Vector3d position;  ///< m
  Eigen::Vector3d velocity;  ///< m/s
};

/// One step of explicit Euler: first the position, with the velocity of the start, and then the
/// velocity.
///
/// @param body at the start of the step
/// @param acceleration m/s², constant
/// @param step s, greater than 0
Body explicit_euler(const Body& body, const Eigen::Vector3d& acceleration, double step);

/// One step of symplectic Euler, as in the lecture: first the velocity, and then the position, with
/// the new velocity.
///
/// @param body, acceleration, step as above
Body semi_implicit_euler(const Body& body, const Eigen::Vector3d& acceleration, double step);

}  // namespace exercise
