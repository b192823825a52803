/// @file
/// Exercise: the first contact of a moving sphere and a plane.
#pragma once

#include <contact/prelude.hpp>

#include <contact/shapes.hpp>

namespace exercise {

/// The first contact of a moving sphere.
struct FirstTouch {
  double t;               ///< fraction of the displacement, from 0 to 1
  Eigen::Vector3d point;  ///< the contact point: on the plane, m
};

/// When and where a sphere that moves in a straight line first touches a plane, or nothing if it
/// does not touch during the step.
///
/// - A sphere that meets the plane at the start touches at t = 0, whatever its displacement; the
///   contact point is then the point of the plane nearest to the centre.
/// - A contact exactly at t = 1 counts.
/// - The sphere may come from the front or from the back.
///
/// @param sphere at the start, m
/// @param displacement of its centre during the step, m
/// @param plane normal·x = offset, with a unit normal; infinite
std::optional<FirstTouch> moving_sphere_plane(const contact::Sphere<double>& sphere,
                                              const Eigen::Vector3d& displacement,
                                              const contact::Plane<double>& plane);

}  // namespace exercise
