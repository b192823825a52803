/// @file
/// Code to break: whether a point is inside a polygon.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <contact/prelude.hpp>

namespace given {

/// The sum of the angles under which the point sees the edges.
inline double sum_of_angles(const std::vector<Eigen::Vector2d>& polygon,
                            const Eigen::Vector2d& point) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d a = polygon[i] - point;
    const Eigen::Vector2d b = polygon[(i + 1) % polygon.size()] - point;
    sum += std::acos(std::clamp(a.dot(b) / (a.norm() * b.norm()), -1.0, 1.0));
  }
  return sum;
}

/// Whether the point is inside the polygon: then it sees the edges all round it.
///
/// @param point no vertex of the polygon
inline bool inside_by_angles(const std::vector<Eigen::Vector2d>& polygon,
                             const Eigen::Vector2d& point) {
  constexpr double tolerance = 0.99;  // for rounding
  return sum_of_angles(polygon, point) >= tolerance * 2 * std::numbers::pi;
}

}  // namespace given
