/// @file
/// Exercise: two triangles by the steps of the lecture.
///
/// All coordinates are whole numbers from -30 to 30, in m, so that a double holds all that the
/// steps need without rounding, as long as nothing is divided: the distances, p and q of step 3 as
/// fractions, and the orientation of p, q and a vertex times their denominators. The answers must
/// be right for every input.
#pragma once

#include <contact/prelude.hpp>

#include <contact/shapes.hpp>

namespace exercise {

/// All points x with normal · x + offset = 0.
struct Plane {
  Eigen::Vector3d normal;
  double offset;
};

/// Step 1: the plane of a triangle. Its normal is as long as twice the triangle's area, and seen
/// from where it points to, the vertices a, b, c are counter-clockwise.
///
/// @param triangle has an area
Plane plane_of(const contact::Triangle<double>& triangle);

/// Step 2: normal · x + offset for x = a, b and c, in this order. These are signed distances from
/// the plane, times the length of its normal.
///
/// @param triangle anywhere
Eigen::Vector3d distances(const contact::Triangle<double>& triangle, const Plane& plane);

/// Step 2: whether these distances of the three vertices show that no point of the triangle is in
/// the plane.
///
/// @param distances whole numbers
bool rejects(const Eigen::Vector3d& distances);

/// Steps 3 and 4: whether the triangles have a point in common, be it a single one.
///
/// @param first has an area
/// @param second has an area. The two are not in one plane
bool triangles_meet(const contact::Triangle<double>& first,
                    const contact::Triangle<double>& second);

}  // namespace exercise
