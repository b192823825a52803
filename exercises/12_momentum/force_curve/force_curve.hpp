/// @file
/// Exercise: what a sampled force does to a body.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// One reading of a force sensor.
struct Sample {
  double time;   ///< s
  double force;  ///< N, with its sign
};

/// What the force has done by the time of the last sample.
struct Push {
  double impulse;         ///< N·s
  double average_force;   ///< the constant force with the same impulse in the same time, N
  double velocity_after;  ///< m/s
};

/// What a force does to a body on which nothing else acts. The motion is along one line, and a sign
/// is a direction. Between two samples the force changes along a straight line.
///
/// @param samples at least two; each is later than the one before, and the times need not be
/// equally far apart
/// @param mass of the body, kg, greater than 0
/// @param velocity at the first sample, m/s
Push push(const std::vector<Sample>& samples, double mass, double velocity);

}  // namespace exercise
