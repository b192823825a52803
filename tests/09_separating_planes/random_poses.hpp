/// @file
/// Random points, directions and rotations of convex bodies.
#pragma once

#include <contact/quaternion.hpp>
#include <contact/vector.hpp>

#include "support/generators.hpp"

namespace random_poses {

using contact::Vector3;
using generators::Random;

/// Each coordinate from -most to most.
inline Vector3<double> any_point(Random& random, double most) {
  const double x = random.uniform(-most, most);
  const double y = random.uniform(-most, most);
  return {x, y, random.uniform(-most, most)};
}
/// A unit vector.
inline Vector3<double> direction(Random& random) {
  for (;;) {
    const Vector3<double> v = any_point(random, 1);
    if (v.norm() > 0.1 && v.norm() <= 1) return v.normalized();
  }
}
/// A stored rotation by a random angle.
inline contact::Matrix3<double> turn(Random& random) {
  const double angle = random.uniform(0, 3);
  return contact::matrix_of(
      contact::exponential<double>(Vector3<double>(direction(random) * angle)));
}

}  // namespace random_poses
