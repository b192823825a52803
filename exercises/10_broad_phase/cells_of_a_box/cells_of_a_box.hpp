/// @file
/// Exercise: the cells of a grid in which a box has a point.
///
/// The cells of a grid in the plane are squares of one edge. They are half open: cell (i, j) has
/// the points with i * edge <= x < (i + 1) * edge and j * edge <= y < (j + 1) * edge, so each point
/// of the plane is in exactly one cell. Coordinates and edges are whole numbers, in µm, and each
/// answer must be exact.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// The number of the cell along an axis that has the coordinate x.
///
/// @param x from -10^18 to 10^18
/// @param edge from 1 to 10^18
std::int64_t cell_of(std::int64_t x, std::int64_t edge);

/// A box: all points from low to high on both axes, ends included. It may have no width or height.
struct Box {
  std::array<std::int64_t, 2> low;   ///< x and y, from -10^18 to 10^18
  std::array<std::int64_t, 2> high;  ///< none of them less than in low
};

/// The cells (i, j) with i from first[0] to last[0] and j from first[1] to last[1].
struct Cells {
  std::array<std::int64_t, 2> first;
  std::array<std::int64_t, 2> last;
};

/// The cells in which the box has a point, and no others.
///
/// @param edge from 1 to 10^18
Cells cells_of(const Box& box, std::int64_t edge);

/// The cell in which a grid compares two boxes.
///
/// Two boxes may share many cells, and a grid that compared them in each would report the pair more
/// than once. It compares them in one of the cells in which both have a point: the one with the
/// smallest i and, of these, the smallest j. If they share no cell, nothing. Boxes that share a
/// cell are compared, whether they touch or not.
///
/// @param edge from 1 to 10^18
std::optional<std::array<std::int64_t, 2>> compared_in(const Box& a, const Box& b,
                                                       std::int64_t edge);

}  // namespace exercise
