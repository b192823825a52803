/// @file
/// Exercise: the impulse of a change of velocity, and the average force.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// The impulse on a body whose velocity changes, in N·s. The sign counts: it is the impulse *on*
/// the body, not that of the body on another.
///
/// @param mass kg, greater than 0
/// @param before velocity before, m/s
/// @param after velocity after, m/s
Eigen::Vector3d impulse_of(double mass, const Eigen::Vector3d& before,
                           const Eigen::Vector3d& after);

/// The average force with this impulse in this time, in N.
///
/// @param impulse N·s
/// @param duration s, greater than 0
Eigen::Vector3d average_force(const Eigen::Vector3d& impulse, double duration);

}  // namespace exercise
