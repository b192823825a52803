/// @file
/// Exercise: the pairs of boxes that touch, by sorting along x and one sweep.
///
/// Coordinates are finite numbers in m. They are only compared, so each answer must be exact.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A box: all points from low to high on both axes, ends included. It may have no width or height.
struct Box {
  Eigen::Vector2d low;
  Eigen::Vector2d high;  ///< no coordinate is less than in low
};

/// The indices of the boxes, in the order in which the boxes start along x: by low.x(). Of boxes
/// that start at the same x, the one with the smaller index comes first.
///
/// @param boxes any number, perhaps none
std::vector<int> order_along_x(const std::vector<Box>& boxes);

/// What a sweep along x finds.
struct Swept {
  /// The pairs of boxes that have a point in common: the smaller index first, each pair once, in
  /// increasing order of the first index, then of the second.
  std::vector<std::array<int, 2>> touching;
  int compared;  ///< how many pairs the sweep compared along y
};

/// The pairs of boxes that touch, by a sweep along x.
///
/// The sweep compares two boxes along y exactly if their intervals along x have a point in common.
/// It compares no pair twice. An interval that ends where another one starts has a point in common
/// with it.
///
/// @param boxes any number, perhaps none
Swept sort_and_sweep(const std::vector<Box>& boxes);

}  // namespace exercise
