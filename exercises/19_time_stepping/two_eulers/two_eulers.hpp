/// @file
/// Exercise: Euler's step in its two orders.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A body that falls.
struct Body {
  Eigen::Vector3d position;  ///< m
  Eigen::Vector3d velocity;  ///< m/s
};

/// One step of Euler's that moves the body first, with the velocity it had, and then changes its
/// velocity.
///
/// @param body at the start of the step
/// @param acceleration m/s², the same everywhere
/// @param step s, greater than 0
Body position_first(const Body& body, const Eigen::Vector3d& acceleration, double step);

/// One step of Euler's that changes the velocity first, and then moves the body with the velocity
/// it has now. The lecture does it so.
///
/// @param body, acceleration, step as above
Body velocity_first(const Body& body, const Eigen::Vector3d& acceleration, double step);

}  // namespace exercise
