/// @file
/// Exercise: the inertia tensor of a box, about another point, and in the axes of the world.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// The inertia tensor of a solid box about its centre of mass, in axes along its edges, in kg·m².
///
/// @param mass kg, greater than 0
/// @param size whole lengths of its edges along x, y and z, m, each greater than 0
Eigen::Matrix3d box_inertia(double mass, const Eigen::Vector3d& size);

/// The inertia tensor of a body about a point other than its centre of mass, in kg·m².
///
/// @param central tensor about the centre of mass, kg·m²
/// @param mass kg, greater than 0
/// @param offset from the centre of mass to the point, m
Eigen::Matrix3d about_point(const Eigen::Matrix3d& central, double mass,
                            const Eigen::Vector3d& offset);

/// The inertia tensor of a rotated body in the axes of the world, in kg·m².
///
/// @param inertia in the body's own axes, kg·m²
/// @param rotation its columns are the body's axes in world coordinates
Eigen::Matrix3d in_world(const Eigen::Matrix3d& inertia, const Eigen::Matrix3d& rotation);

}  // namespace exercise
