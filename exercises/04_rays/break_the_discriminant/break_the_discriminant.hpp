/// @file
/// Exercise: rays for which a discriminant is wrong.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A ray and a ball.
///
/// For all functions: all numbers are whole; the coordinates of origin and centre are from -1000 to
/// 1000, those of the direction from -10000 to 10000, and the radius is from 1 to 1000. The ray
/// starts outside the ball, at most 1000 m from its centre, and leads towards it: the distance from
/// the centre decreases at first.
struct Shot {
  Eigen::Vector3d origin;     ///< m
  Eigen::Vector3d direction;  ///< of any length
  Eigen::Vector3d centre;     ///< m
  double radius;              ///< m
};

/// A ball that given::hits_by_discriminant misses, although at least 0.25 m of the ray is in it.
Shot missed_ball();

/// A ball that given::hits_by_discriminant hits, although the ray passes at least 0.01 m beside it.
Shot ball_beside_the_ray();

/// A ball that given::hits_by_discriminant misses, although the ray starts at most 150 m from its
/// centre and passes through its interior.
Shot near_ball();

}  // namespace exercise
