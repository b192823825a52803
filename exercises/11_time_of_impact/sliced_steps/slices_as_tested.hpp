/// @file
/// Code to break: whether moving bodies meet, by tests of overlap at the ends of equal slices of
/// the step, as programs do it.
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

/// When a bullet first touches a plate: a ball that moves perpendicular to the plate, from start to
/// start + displacement of its centre.
template <class Shot>
std::optional<double> bullet_meets_plate(const Shot& shot, int slices) {
  return first_of_slices(
      [&](double t) {
        const double x = shot.start + t * shot.displacement;
        return x + shot.radius >= shot.plate && x - shot.radius <= shot.plate + shot.thickness;
      },
      slices);
}

/// When a moving disc first touches one whose centre is at rest at the origin.
template <class Pass>
std::optional<double> disc_meets_disc(const Pass& pass, int slices) {
  return first_of_slices(
      [&](double t) {
        const Eigen::Vector2d centre = pass.start + t * pass.displacement;
        return centre.squaredNorm() <= pass.radii * pass.radii;
      },
      slices);
}

}  // namespace given
