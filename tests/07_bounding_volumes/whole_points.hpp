/// @file
/// Points whose coordinates are whole numbers, in integers: what tests of exercises compare with.
#pragma once

#include <algorithm>
#include <contact/shapes.hpp>
#include <cstdint>
#include <vector>

namespace whole_points {

using Point = Eigen::Vector3d;

/// Of coordinates below 2^31.
inline std::int64_t dot(const Point& u, const Point& v) {
  std::int64_t sum = 0;
  for (int i = 0; i < 3; ++i)
    sum += static_cast<std::int64_t>(u[i]) * static_cast<std::int64_t>(v[i]);
  return sum;
}

/// Whether all coordinates are whole numbers of at most this magnitude. NaN is not.
inline bool all_whole(const std::vector<Point>& points, double limit) {
  return std::all_of(points.begin(), points.end(), [limit](const Point& p) {
    return p == p.array().round().matrix() && p.cwiseAbs().maxCoeff() <= limit;
  });
}

}  // namespace whole_points
