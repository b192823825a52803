/// @file
/// Exercise: a velocity, split along a direction and across it.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

struct Parts {
  Eigen::Vector3d along;   ///< parallel to the direction, m/s
  Eigen::Vector3d across;  ///< the rest, upright on the direction, m/s
};

/// How fast something moves along the direction, in m/s: positive if it moves with it, negative if
/// against it.
///
/// @param velocity m/s
/// @param direction of any length; only where it points counts. Without length it points nowhere:
/// std::invalid_argument.
double speed_along(const Eigen::Vector3d& velocity, const Eigen::Vector3d& direction);

/// The velocity as a sum of two: one along the direction (or against it), one upright on it.
///
/// @param velocity m/s
/// @param direction of any length; only where it points counts. Without length it points nowhere:
/// std::invalid_argument.
Parts split(const Eigen::Vector3d& velocity, const Eigen::Vector3d& direction);

}  // namespace exercise
