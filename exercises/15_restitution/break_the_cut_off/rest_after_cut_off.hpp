/// @file
/// Code to break: the time after which a dropped ball is at rest.
#pragma once

#include <cmath>

#include <contact/prelude.hpp>

namespace given {

/// The time from the drop until the ball is at rest, in s, with g = 9.81 m/s^2.
///
/// Flights are added until one is shorter than a millisecond, and at most a thousand of them, so
/// that the loop ends.
/// @param height of the drop, m
/// @param k coefficient of restitution
inline double rest_after_cut_off(double height, double k) {
  const double fall = std::sqrt(2 * height / 9.81);
  double time = fall;
  double flight = 2 * k * fall;
  for (int bounces = 0; flight >= 0.001 && bounces < 1000; ++bounces) {
    time += flight;
    flight *= k;
  }
  return time;
}

}  // namespace given
