/// @file
/// Code to break: when two discs touch.
#pragma once

#include <cmath>
#include <optional>

#include <contact/prelude.hpp>

namespace given {

/// The time at which two discs in uniform motion first touch, in s from now: the smaller root of
/// |position + t velocity| = radii. 0 if they overlap and approach. Nothing if they never touch.
///
/// @param position, velocity of B relative to A, in m and m/s
/// @param radii the sum of the radii, m
inline std::optional<double> time_of_touch(const Eigen::Vector2d& position,
                                           const Eigen::Vector2d& velocity, double radii) {
  const double a = velocity.dot(velocity);
  const double b = position.dot(velocity);
  const double c = position.dot(position) - radii * radii;
  const double discriminant = b * b - a * c;
  if (discriminant < 0) return std::nullopt;
  const double time = (-b - std::sqrt(discriminant)) / a;
  if (time < 0) return std::nullopt;
  return time;
}

}  // namespace given
