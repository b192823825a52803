/// @file
/// Exercise: rays whose hits a threshold loses.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A ray and a triangle, in m.
struct Shot {
  Eigen::Vector3d origin;
  Eigen::Vector3d direction;  ///< not zero, of any length
  Eigen::Vector3d a;
  Eigen::Vector3d b;
  Eigen::Vector3d c;
};

/// A hit that given::hit_with_epsilon misses, of a small triangle. The direction is (0, 0, -1), and
/// the hit is away from every edge: each barycentric weight is at least 0.2.
Shot small_triangle();

/// A hit that given::hit_with_epsilon misses. The triangle is (0, 0, 0), (4, 0, 0), (0, 4, 0), and
/// each barycentric weight is at least 0.2.
Shot short_direction();

/// A hit that given::hit_with_epsilon misses. Every coordinate is a whole number from -10 to 10.
Shot whole_numbers();

}  // namespace exercise
