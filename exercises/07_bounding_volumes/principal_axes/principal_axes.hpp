/// @file
/// Exercise: points for which the box along their principal axes is a bad one.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A convex body as the points of its hull, at least 4 and at most 20, not all in one plane, and
/// one point more.
struct Body {
  std::vector<Eigen::Vector3d> points;
  Eigen::Vector3d added;  ///< inside the body or on its surface, perhaps one of the points again
};

/// Points whose box has at least twice the volume of the axis-aligned box, by
/// given::principal_volume. Each of them is a vertex of their convex hull, and none is stored
/// twice. There are 4 to 20, not all in one plane, and every coordinate is a whole number from -10
/// to 10.
std::vector<Eigen::Vector3d> larger_than_the_aligned_box();

/// A body and a point of it. With this point added to the others, the box has at least twice the
/// volume as without, by given::principal_volume, although the body is the same. Every coordinate
/// is a whole number from -10 to 10.
Body changed_by_a_point();

/// The eight vertices of a cube, in any order, whose box has at least 1.5 times the volume of the
/// cube, by given::principal_volume. Every coordinate is a whole number from -100 to 100.
std::vector<Eigen::Vector3d> cube_in_a_large_box();

}  // namespace exercise
