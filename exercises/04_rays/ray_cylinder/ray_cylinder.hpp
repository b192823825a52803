/// @file
/// Exercise: where a ray enters a cylinder.
#pragma once

#include <contact/prelude.hpp>

#include <contact/shapes.hpp>

namespace exercise {

/// A solid cylinder with flat caps: all points whose distance from the line through the two points
/// is at most radius, and that are between the planes perpendicular to it through the two points.
struct Cylinder {
  Eigen::Vector3d start;  ///< the centre of one cap, m
  Eigen::Vector3d end;    ///< the centre of the other; another point than start, m
  double radius;          ///< positive, m
};

/// Where a ray enters a cylinder.
struct Entry {
  double t;  ///< in multiples of the direction as given; 0 if the ray starts in the cylinder
  Eigen::Vector3d normal;  ///< outward, of length 1; (0, 0, 0) if the ray starts in the cylinder
};

/// Where the ray enters the cylinder, through its wall or through a cap. Nothing, if it misses.
///
/// Touching the wall counts. The tests ask for no ray that enters or leaves exactly where wall and
/// cap meet, and for none that starts exactly on the surface.
///
/// @param ray origin in m; direction of any length but not zero, in m for each unit of t
std::optional<Entry> ray_cylinder(const contact::Ray<double>& ray, const Cylinder& cylinder);

}  // namespace exercise
