/// @file
/// Exercise: boxes for which the cells of a grid are computed wrongly.
///
/// A box is an interval of one axis, ends included. Cell k of a grid has the points with
/// k * edge <= x < (k + 1) * edge. All numbers are meant as they are stored: no number is 0.1
/// exactly.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A grid and two boxes: the points from low_a to high_a, and those from low_b to high_b.
struct Pair {
  double edge;  ///< of the cells
  double low_a;
  double high_a;  ///< not less than low_a
  double low_b;
  double high_b;  ///< not less than low_b
};

/// Boxes of which given::cells_by_truncation puts the first in a cell in which it has no point, and
/// in which given::cells_to_search, which rounds down, does not put it; the second is not asked.
/// The edge is from 0.01 to 10, and the coordinates are from -100 to 100.
Pair in_a_cell_without_a_point();

/// Boxes with a common point of which given::is_found says that a does not find b. The edge is from
/// 0.01 to 10, and the coordinates are from -100 to 100.
Pair lost_by_the_reciprocal();

/// Boxes with a common point for which given::share_a_key says that they have no key in common. If
/// the key of each cell were the product k * edge, they would have one. The edge is from 0.01 to
/// 10, and the coordinates are from -10 to 10.
Pair lost_by_added_keys();

}  // namespace exercise
