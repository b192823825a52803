/// @file
/// Exercise: the first contact of a sphere and a plane that both move, by the plane offset by the
/// radius.
///
/// Times are fractions of the step: 0 at its start, 1 at its end. Coordinates are in m.
#pragma once

#include <contact/prelude.hpp>

#include <contact/shapes.hpp>

namespace exercise {

/// The plane on which the centre of a sphere is when the sphere touches the given plane from the
/// side on which it is. A sphere whose centre is in the plane counts as in front of it.
///
/// @param plane normal·x = offset, with a unit normal; infinite
/// @param sphere anywhere, with a radius of 0 or more
/// @return with the same normal
contact::Plane<double> offset_plane(const contact::Plane<double>& plane,
                                    const contact::Sphere<double>& sphere);

/// The first contact.
struct Contact {
  double t;               ///< fraction of the step, from 0 to 1
  Eigen::Vector3d point;  ///< on the plane, where the plane is at t
};

/// When and where a sphere first touches a plane. Both move, each in a straight line at a constant
/// velocity. Nothing if they do not touch during the step.
///
/// - If they touch or overlap at the start, t is 0, whatever their displacements. The contact point
///   is then the point of the plane nearest to the centre.
/// - A contact exactly at t = 1 counts.
/// - The sphere may be on either side.
/// - Lengths may be as small as 1e-200 m.
///
/// @param sphere at the start, with a radius of 0 or more
/// @param displacement of its centre during the step
/// @param plane at the start: normal·x = offset, with a unit normal; infinite
/// @param rise of the plane along its normal during the step
std::optional<Contact> sphere_meets_plane(const contact::Sphere<double>& sphere,
                                          const Eigen::Vector3d& displacement,
                                          const contact::Plane<double>& plane, double rise);

}  // namespace exercise
