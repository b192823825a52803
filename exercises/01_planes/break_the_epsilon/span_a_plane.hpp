/// @file
/// Code to break: whether three points span a plane.
#pragma once

#include <contact/prelude.hpp>

namespace given {

/// Whether three points, in m, span a plane: whether they are not on one line.
inline bool span_a_plane(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                         const Eigen::Vector3d& c) {
  return (b - a).cross(c - a).norm() > 1e-6;
}

}  // namespace given
