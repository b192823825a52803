/// @file
/// Exercise: the total momentum of several bodies, and their velocity if they stick together.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

struct Body {
  double mass;               ///< kg
  Eigen::Vector3d velocity;  ///< m/s
};

/// The total momentum of all bodies, in kg·m/s. Zero for no bodies.
Eigen::Vector3d total_momentum(const std::vector<Body>& bodies);

/// The common velocity of all bodies after they have stuck together, in m/s. No external force
/// acts.
///
/// It throws std::invalid_argument if there are no bodies, or if a mass is not greater than 0.
Eigen::Vector3d velocity_together(const std::vector<Body>& bodies);

}  // namespace exercise
