/// @file
/// Exercise: the momentum of several bodies, and their velocity once they stick together.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

struct Body {
  double mass;               ///< kg
  Eigen::Vector3d velocity;  ///< m/s
};

/// The momentum of all bodies together, in kg·m/s. Zero for no bodies.
Eigen::Vector3d total_momentum(const std::vector<Body>& bodies);

/// The velocity of all bodies once they have stuck together, in m/s. No force acts from outside.
///
/// It throws std::invalid_argument if there are no bodies, or if a mass is not greater than 0.
Eigen::Vector3d velocity_together(const std::vector<Body>& bodies);

}  // namespace exercise
