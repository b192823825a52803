/// @file
/// Exercise: the line of impact, and the normal and tangential components of a velocity.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// The unit vector along the line of two discs' centres, from B to A. Nothing if the centres
/// coincide.
///
/// @param centre_a, centre_b m
std::optional<Eigen::Vector2d> line_of_centres(const Eigen::Vector2d& centre_a,
                                               const Eigen::Vector2d& centre_b);

/// A velocity as the sum of two perpendicular ones.
struct Components {
  Eigen::Vector2d normal;      ///< normal component, parallel to the axis, m/s
  Eigen::Vector2d tangential;  ///< tangential component, perpendicular to it, m/s
};

/// The components of a velocity along an axis and perpendicular to it.
///
/// @param velocity m/s
/// @param axis a unit vector
Components components(const Eigen::Vector2d& velocity, const Eigen::Vector2d& axis);

}  // namespace exercise
