/// @file
/// Exercise: points on which a hull that sorts by angle is wrong.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// Points for which given::hull_by_angles loses a vertex of the hull.
///
/// For all three functions: at most 50 points, different from one another, not all on one line.
/// For this one: every coordinate is a whole number from -10 to 10.
std::vector<Eigen::Vector2d> points_that_lose_a_vertex();

/// Points for which given::hull_by_angles returns every vertex, and another point as well. Every
/// coordinate is a whole number from -10 to 10.
std::vector<Eigen::Vector2d> points_with_an_extra_vertex();

/// Points on which given::hull_by_angles is wrong although no two of them are in the same direction
/// from the lowest point. Every coordinate is a whole number from -2^30 to 2^30.
std::vector<Eigen::Vector2d> points_in_different_directions();

}  // namespace exercise
