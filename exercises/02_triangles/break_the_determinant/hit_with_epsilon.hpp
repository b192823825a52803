/// @file
/// Code to break: whether a ray hits a triangle.
#pragma once

#include <cmath>

#include <contact/prelude.hpp>

namespace given {

/// Whether the ray origin + t direction with t >= 0 hits the triangle, by Moller and Trumbore. A
/// hit on an edge, on a vertex or at the origin of the ray should count.
inline bool hit_with_epsilon(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                             const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                             const Eigen::Vector3d& c) {
  constexpr double epsilon = 1e-6;
  const Eigen::Vector3d ab = b - a, ac = c - a;
  const Eigen::Vector3d p = direction.cross(ac);
  const double determinant = ab.dot(p);
  if (std::abs(determinant) < epsilon) return false;  // parallel
  const Eigen::Vector3d s = origin - a;
  const double u = s.dot(p) / determinant;
  if (u < 0 || u > 1) return false;
  const Eigen::Vector3d q = s.cross(ab);
  const double v = direction.dot(q) / determinant;
  if (v < 0 || u + v > 1) return false;
  return ac.dot(q) / determinant > epsilon;
}

}  // namespace given
