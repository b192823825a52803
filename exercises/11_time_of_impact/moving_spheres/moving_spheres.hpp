/// @file
/// Exercise: the first contact of two moving spheres.
///
/// Times are fractions of the step: 0 at its start, 1 at its end. Coordinates are in m.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A sphere that moves in a straight line at a constant velocity.
struct MovingSphere {
  Eigen::Vector3d centre;        ///< at the start of the step
  Eigen::Vector3d displacement;  ///< of the centre during the step
  double radius;                 ///< greater than 0
};

/// The first contact.
struct Contact {
  double t;               ///< fraction of the step, from 0 to 1
  Eigen::Vector3d point;  ///< between the two centres at t, dividing them as the radii do
};

/// When and where two moving spheres first touch. Nothing if they do not touch during the step.
///
/// - If they touch or overlap at the start, t is 0, whatever their displacements.
/// - A contact exactly at t = 1 counts, and so does a graze: paths on which the spheres touch in
///   one point and never overlap.
/// - Seen along the centres, the distances of the point from those of a and b are in the ratio of
///   the radii. If the spheres just touch, it is the point in which they touch.
///
/// The relative error of t may be 2⁻⁴⁰, also for small spheres 10⁹ radii apart. Spheres
/// that nearly touch at the start are asked for where the squares of the distance and of the sum of
/// the radii are doubles: the difference of these squares may then be taken as it is.
std::optional<Contact> spheres_meet(const MovingSphere& a, const MovingSphere& b);

}  // namespace exercise
