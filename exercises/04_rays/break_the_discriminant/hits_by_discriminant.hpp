/// @file
/// Code to break: whether a ray hits a ball.
#pragma once

#include <cmath>

#include <contact/prelude.hpp>

namespace given {

/// The products are added from left to right.
inline float dot(const Eigen::Vector3f& u, const Eigen::Vector3f& v) {
  return u.x() * v.x() + u.y() * v.y() + u.z() * v.z();
}

/// b² − 4 a c of the equation a t² + b t + c = 0 for the t at which the ray meets the sphere.
inline float discriminant(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                          const Eigen::Vector3d& centre, double radius) {
  const Eigen::Vector3f m = origin.cast<float>() - centre.cast<float>();
  const Eigen::Vector3f d = direction.cast<float>();
  const float r = static_cast<float>(radius);
  const float a = dot(d, d);
  const float b = 2 * dot(m, d);
  const float c = dot(m, m) - r * r;
  return b * b - 4 * a * c;
}

/// Whether the ray origin + t direction with t >= 0 hits the sphere, from outside.
inline bool hits_by_discriminant(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                                 const Eigen::Vector3d& centre, double radius) {
  if (discriminant(origin, direction, centre, radius) <= 0) return false;
  return direction.dot(origin - centre) < 0;
}

}  // namespace given
