/// @file
/// Whether volumes that a reader returns contain the points, without rounding. For the tests of the
/// exercises, which also run in the page.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include <contact/exact.hpp>

namespace contained {

using contact::Exact;

/// Whether |p − centre| ≤ radius for each point p.
template <class Vector>
bool in_ball(const Vector& centre, double radius, const std::vector<Vector>& points) {
  if (!centre.allFinite() || !std::isfinite(radius) || radius < 0) return false;
  for (const Vector& p : points) {
    Exact square = -(Exact(radius) * Exact(radius));
    for (Eigen::Index k = 0; k < p.size(); ++k) {
      const Exact x = Exact(p[k]) - Exact(centre[k]);
      square += x * x;
    }
    if (square.sign() > 0) return false;
  }
  return true;
}

/// Whether |axis · (p − centre)| ≤ half length for each point p and each column of axes.
inline bool in_slabs(const Eigen::Matrix3d& axes, const Eigen::Vector3d& centre,
                     const Eigen::Vector3d& half_lengths,
                     const std::vector<Eigen::Vector3d>& points) {
  if (!axes.allFinite() || !centre.allFinite() || !half_lengths.allFinite()) return false;
  for (const Eigen::Vector3d& p : points) {
    for (Eigen::Index j = 0; j < 3; ++j) {
      Exact along;
      for (Eigen::Index i = 0; i < 3; ++i)
        along += Exact(axes(i, j)) * (Exact(p[i]) - Exact(centre[i]));
      if (abs(along) > Exact(half_lengths[j])) return false;
    }
  }
  return true;
}

/// Whether all coordinates are multiples of 1/parts, at most `limit` from 0.
template <class Vector>
bool is_on_grid(const std::vector<Vector>& points, double parts, double limit) {
  for (const Vector& p : points) {
    if (!p.allFinite() || p.cwiseAbs().maxCoeff() > limit) return false;
    for (Eigen::Index k = 0; k < p.size(); ++k)
      if (p[k] * parts != std::round(p[k] * parts)) return false;
  }
  return true;
}

}  // namespace contained
