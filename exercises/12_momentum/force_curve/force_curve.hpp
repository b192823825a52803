/// @file
/// Exercise: the effect of a sampled force on a body.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// One reading of a force sensor.
struct Sample {
  double time;   ///< s
  double force;  ///< N, with its sign
};

/// The effect of the force up to the last sample.
struct ForceEffect {
  double impulse;         ///< N·s
  double average_force;   ///< the constant force with the same impulse in the same time, N
  double velocity_after;  ///< m/s
};

/// The effect of a force on a body on which no other force acts. The motion is along one line, and
/// signs are directions. Between two samples the force is linear.
///
/// @param samples at least two; each is later than the one before; the times need not be equally
/// spaced
/// @param mass of the body, kg, greater than 0
/// @param velocity at the first sample, m/s
ForceEffect apply_force(const std::vector<Sample>& samples, double mass, double velocity);

}  // namespace exercise
