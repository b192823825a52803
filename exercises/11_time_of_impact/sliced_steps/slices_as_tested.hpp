/// @file
/// Code to break: whether a moving disc meets an obstacle at rest, by tests of overlap at the ends
/// of equal slices of the step, as programs do it.
#pragma once

#include <optional>

#include <contact/prelude.hpp>

namespace given {

/// The first of the times 0, 1/slices, 2/slices, …, 1 at which overlap(t) holds.
template <class Overlap>
std::optional<double> first_of_slices(const Overlap& overlap, int slices) {
  for (int k = 0; k <= slices; ++k) {
    const double t = double(k) / slices;
    if (overlap(t)) return t;
  }
  return std::nullopt;
}

/// When the disc touches a plate: all points with 0 <= x <= size.
template <class Shot>
std::optional<double> meets_plate(const Shot& shot, int slices) {
  return first_of_slices(
      [&](double t) {
        const double x = shot.start.x() + t * shot.displacement.x();
        return x + shot.radius >= 0 && x - shot.radius <= shot.size;
      },
      slices);
}

/// When the disc touches another one, of radius size about the origin.
template <class Shot>
std::optional<double> meets_disc(const Shot& shot, int slices) {
  return first_of_slices(
      [&](double t) {
        const Eigen::Vector2d centre = shot.start + t * shot.displacement;
        const double radius_sum = shot.radius + shot.size;
        return centre.squaredNorm() <= radius_sum * radius_sum;
      },
      slices);
}

}  // namespace given
