/// @file
/// Exercise: the contact normal of a perimeter, from the movement of a vertex.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// Where a moving vertex meets a perimeter.
struct Entry {
  int segment;             ///< of the perimeter: 0 for the one from vertex 0 to vertex 1
  double t;                ///< the fraction of the movement before it, from 0 to 1
  Eigen::Vector2d normal;  ///< of the segment, a unit vector that points out of the perimeter
};

/// Where a vertex of another body meets the perimeter first, on its way through one step of the
/// simulation. Nothing, if it does not meet the perimeter in this step.
///
/// Meeting it at the very end of the movement counts.
///
/// @param perimeter at least 3 vertices, counter-clockwise, convex or concave; it does not cross
///   itself, and the last segment goes from the last vertex to the first, m
/// @param from where the vertex is at the beginning: outside, and not on the perimeter, m
/// @param to where it would be at the end without the perimeter: outside, inside, or on a segment.
///   The path from `from` to `to` passes through no vertex and along no segment; it may be a point,
///   m
std::optional<Entry> perimeter_normal(const std::vector<Eigen::Vector2d>& perimeter,
                                      const Eigen::Vector2d& from, const Eigen::Vector2d& to);

}  // namespace exercise
