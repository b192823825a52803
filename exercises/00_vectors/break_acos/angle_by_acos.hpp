/// @file
/// Code to break: the angle between two vectors.
#pragma once

#include <cmath>

#include <contact/prelude.hpp>

namespace given {

/// The angle between two vectors that are not zero, in radians, from 0 to pi.
inline double angle_by_acos(const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
  return std::acos(u.dot(v) / std::sqrt(u.dot(u) * v.dot(v)));
}

}  // namespace given
