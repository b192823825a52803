/// @file
/// Exercise: where a ray enters a box.
#pragma once

#include <contact/prelude.hpp>

#include <contact/shapes.hpp>

namespace exercise {

/// All points x with low ≤ x ≤ high in each coordinate: a solid box, faces included. It may be flat
/// or a single point.
struct Box {
  Eigen::Vector3d low;   ///< the corner with the smallest coordinates, m
  Eigen::Vector3d high;  ///< the corner with the largest coordinates, m
};

/// Where a ray enters a box.
struct Entry {
  double t;  ///< in multiples of the direction as given; 0 if the ray starts in the box
  /// The axis perpendicular to the face through which the ray enters: 0, 1 or 2 for x, y
  /// or z. It is -1 if the ray starts in the box and enters through no face.
  int axis;
};

/// Where the ray enters the box. Nothing, if it misses the box.
///
/// - Touching counts: a corner, an edge, or a ray in the plane of a face.
/// - A ray that enters through an edge or a corner enters through two or three faces: axis is the
///   lowest of theirs. A face that is parallel to the ray is not entered, not even by a ray in its
///   plane.
/// - A ray that starts on a face and leads into the box enters there, at t = 0.
///
/// @param ray origin in m; direction of any length but not zero, in m for each unit of t; some of
///   its components may be zero, with either sign
/// @param box in m
std::optional<Entry> ray_box(const contact::Ray<double>& ray, const Box& box);

}  // namespace exercise
