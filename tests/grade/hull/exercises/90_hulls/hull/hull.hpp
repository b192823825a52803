/// @file
/// Exercise: the vertices of a hull, by their indices.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// Indices of the vertices of the convex hull, counter-clockwise, starting with any of them. No
/// three points are on a line.
///
/// @param points at least three, m
std::vector<int> hull(const std::vector<Eigen::Vector2d>& points);

}  // namespace exercise
