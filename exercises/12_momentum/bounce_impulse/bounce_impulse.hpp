/// @file
/// Exercise: the impulse that a change of velocity takes, and the average force behind it.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// The impulse on a body that changes its velocity, in N·s. The direction counts: it is the impulse
/// *on* the body.
///
/// @param mass kg, greater than 0
/// @param before velocity before, m/s
/// @param after velocity after, m/s
Eigen::Vector3d impulse_of(double mass, const Eigen::Vector3d& before,
                           const Eigen::Vector3d& after);

/// The average force that gives this impulse in this time, in N.
///
/// @param impulse N·s
/// @param duration s, greater than 0
Eigen::Vector3d average_force(const Eigen::Vector3d& impulse, double duration);

}  // namespace exercise
