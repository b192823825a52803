/// @file
/// Exercise: barycentric coordinates, and what they are good for.
#pragma once

#include <contact/prelude.hpp>

#include <contact/shapes.hpp>

namespace exercise {

/// What the surface carries at one point: air that flows over it.
struct Air {
  double temperature = 0;                              ///< K
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< m/s
};

/// The weights of the corners a, b and c, in that order, with which the corners add up to the
/// point. Their sum is 1; a weight is negative if the point lies beyond the side opposite its
/// corner.
///
/// @param triangle corners in m. Without area it has no weights: std::invalid_argument.
/// @param point in the plane of the triangle, inside or outside, m
Eigen::Vector3d barycentric(const contact::Triangle<double>& triangle,
                            const Eigen::Vector3d& point);

/// The air at a point with these weights, when it is a, b and c at the corners and changes evenly
/// between them.
///
/// @param weights of a, b and c in that order; their sum is 1
Air interpolated(const Air& a, const Air& b, const Air& c, const Eigen::Vector3d& weights);

}  // namespace exercise
