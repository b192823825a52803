/// @file
/// Exercise: whether a sphere meets a plane, with and without a square root.
#pragma once

#include <contact/prelude.hpp>

#include <contact/shapes.hpp>

namespace exercise {

/// A plane normal·x = offset whose normal has any length but zero.
struct RawPlane {
  Eigen::Vector3d normal;
  double offset;
};

/// Whether the sphere and the plane have a point in common. Touching counts; the side does not
/// matter.
///
/// @param sphere centre and radius, m; the radius is not negative
/// @param plane with a unit normal
bool meets(const contact::Sphere<double>& sphere, const contact::Plane<double>& plane);

/// The same for a plane whose normal need not be a unit vector, without a square root and without a
/// division: if all numbers are small integers, nothing is rounded and touching is decided exactly.
bool meets_raw(const contact::Sphere<double>& sphere, const RawPlane& plane);

}  // namespace exercise
