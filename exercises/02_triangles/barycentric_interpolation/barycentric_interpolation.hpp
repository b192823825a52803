/// @file
/// Exercise: barycentric coordinates and interpolation.
#pragma once

#include <contact/prelude.hpp>

#include <contact/shapes.hpp>

namespace exercise {

/// Air that flows over the surface, at one point.
struct Air {
  double temperature = 0;                              ///< K
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< m/s
};

/// The weights of the vertices a, b and c, in that order, for which the weighted sum of the
/// vertices is the point. Their sum is 1; a weight is negative if the point is beyond the edge
/// opposite its vertex.
///
/// @param triangle vertices in m. Without area there are no weights: std::invalid_argument.
/// @param point in the plane of the triangle, inside or outside, m
Eigen::Vector3d barycentric(const contact::Triangle<double>& triangle,
                            const Eigen::Vector3d& point);

/// The air at a point with these weights, interpolated linearly between a, b and c at the vertices.
///
/// @param weights of a, b and c in that order; their sum is 1
Air interpolated(const Air& a, const Air& b, const Air& c, const Eigen::Vector3d& weights);

}  // namespace exercise
