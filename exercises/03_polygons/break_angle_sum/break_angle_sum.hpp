/// @file
/// Exercise: points outside a polygon whose angles add up to a full turn.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A polygon and a point.
///
/// For all functions: the polygon has 3 to 12 vertices, in order and in either orientation, and
/// does not cross or touch itself; the point is not on it; all coordinates are whole numbers, in m.
struct Query {
  std::vector<Eigen::Vector2d> polygon;
  Eigen::Vector2d point;
};

/// A triangle and a point at which given::inside_by_angles is wrong. Every coordinate is from -1000
/// to 1000.
Query outside_a_triangle();

/// A quadrilateral and a point at which given::inside_by_angles is wrong. Every coordinate is from
/// -10 to 10, and the point is at least 1 m from the quadrilateral's boundary.
Query outside_a_quadrilateral();

/// A polygon and a point at which given::inside_by_angles is wrong, although the point is at least
/// 1 m outside the polygon's bounding box: to the left or right of all vertices, or above or below
/// them. Every coordinate is from -10 to 10.
Query outside_the_bounding_box();

}  // namespace exercise
