/// @file
/// Exercise: a velocity, split into a part along a direction and a perpendicular part.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

struct Components {
  Eigen::Vector3d parallel;       ///< parallel to the direction, m/s
  Eigen::Vector3d perpendicular;  ///< the rest, perpendicular to the direction, m/s
};

/// The component of the velocity along the direction, in m/s: positive for motion in the direction,
/// negative for motion against it.
///
/// @param velocity m/s
/// @param direction of any length; only its direction matters. The zero vector has none:
/// std::invalid_argument.
double speed_along(const Eigen::Vector3d& velocity, const Eigen::Vector3d& direction);

/// The velocity as a sum of two parts: one parallel to the direction, one perpendicular to it.
///
/// @param velocity m/s
/// @param direction of any length; only its direction matters. The zero vector has none:
/// std::invalid_argument.
Components split(const Eigen::Vector3d& velocity, const Eigen::Vector3d& direction);

}  // namespace exercise
