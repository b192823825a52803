#include "cells_of_a_box.hpp"

namespace exercise {

std::int64_t cell_of(std::int64_t x, std::int64_t edge) {
  //? Division of whole numbers drops the remainder, which is not negative for a positive x.
  //? gap: x / edge
  const std::int64_t towards_zero = x / edge;
  //? A negative remainder means that zero is nearer than x, so the cell is the one below.
  //? gap: x % edge < 0
  return x % edge < 0 ? towards_zero - 1 : towards_zero;
}

Cells cells_of(const Box& box, std::int64_t edge) {
  //? The box is closed, so it has its upper corner too. Cells do not decrease as x grows: all
  //? others are between.
  //? gap: cell_of(box.high[axis], edge)
  Cells cells{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    cells.first[axis] = cell_of(box.low[axis], edge);
    cells.last[axis] = cell_of(box.high[axis], edge);
  }
  return cells;
}

std::optional<std::array<std::int64_t, 2>> compared_in(const Box& a, const Box& b,
                                                       std::int64_t edge) {
  //? On each axis the cells of a box are a range, and so are those that two boxes share.
  const Cells of_a = cells_of(a, edge), of_b = cells_of(b, edge);
  std::array<std::int64_t, 2> cell{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    //? Both have begun where the later one begins.
    //? gap: std::max(of_a.first[axis], of_b.first[axis])
    cell[axis] = std::max(of_a.first[axis], of_b.first[axis]);
    //? If one has ended before, there is no common cell, whatever the other axis says.
    //? gap: std::min(of_a.last[axis], of_b.last[axis])
    if (cell[axis] > std::min(of_a.last[axis], of_b.last[axis])) return std::nullopt;
  }
  //? Otherwise this cell is in both ranges, and no smaller one is.
  return cell;
}

}  // namespace exercise
