/// @file
/// Cells of a grid, right by their definition or with one mistake that people make: what the test
/// of the exercise compares with and recognises.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>

#include "cells_of_a_box.hpp"

namespace cells_with_mistakes {

using exercise::Box;
using exercise::Cells;
using Cell = std::optional<std::array<std::int64_t, 2>>;

/// The cell by its definition: x less the distance from the cell's lower border, which is from 0 to
/// less than an edge. No sum exceeds 2 * 10^18.
inline std::int64_t cell_of(std::int64_t x, std::int64_t edge) {
  const std::int64_t above_border = (x % edge + edge) % edge;
  return (x - above_border) / edge;
}

/// How a coordinate becomes a number.
enum class Number { rightly, truncated, rounded, mirrored, lowered, in_double };

inline std::int64_t cell_with(Number number, std::int64_t x, std::int64_t edge) {
  switch (number) {
    case Number::truncated:
      return x / edge;
    case Number::rounded: {
      const std::int64_t cell = cell_of(x, edge);
      const std::int64_t above_border = x - cell * edge;
      return above_border >= edge - above_border ? cell + 1 : cell;
    }
    case Number::mirrored:
      return std::abs(x) / edge;
    case Number::lowered:
      return x < 0 ? x / edge - 1 : x / edge;
    case Number::in_double:
      return static_cast<std::int64_t>(
          std::floor(static_cast<double>(x) / static_cast<double>(edge)));
    case Number::rightly:
      break;
  }
  return cell_of(x, edge);
}

/// Which cells a box gets.
enum class Range { rightly, open, one_more, lower_corner, centre, by_size, width_twice };

inline Cells cells_of(const Box& box, std::int64_t edge, Range range = Range::rightly) {
  Cells cells{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    std::int64_t &first = cells.first[axis], &last = cells.last[axis];
    const std::int64_t low = box.low[axis], high = box.high[axis];
    first = cell_of(low, edge);
    last = cell_of(high, edge);
    if (range == Range::open) last = std::max(first, cell_of(high - 1, edge));
    if (range == Range::one_more) last = last + 1;
    if (range == Range::lower_corner) last = first;
    if (range == Range::centre) first = last = cell_of(low + (high - low) / 2, edge);
    if (range == Range::by_size) last = first + (high - low) / edge;
    if (range == Range::width_twice && axis == 1) {
      first = cells.first[0];
      last = cells.last[0];
    }
  }
  return cells;
}

/// In which cell a pair is compared.
enum class Shared { rightly, smaller_first, last, of_a, of_b, one_axis, longer };

inline Cell compared_in(const Box& a, const Box& b, std::int64_t edge,
                        Shared shared = Shared::rightly) {
  const Cells x = cells_with_mistakes::cells_of(a, edge),
              y = cells_with_mistakes::cells_of(b, edge);
  std::array<std::int64_t, 2> begin{}, end{};
  std::array<bool, 2> common{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    begin[axis] = std::max(x.first[axis], y.first[axis]);
    end[axis] = std::min(x.last[axis], y.last[axis]);
    common[axis] = shared == Shared::longer ? begin[axis] < end[axis] : begin[axis] <= end[axis];
  }
  const bool some = shared == Shared::one_axis && (common[0] || common[1]);
  if (!some && !(common[0] && common[1])) return std::nullopt;
  if (shared == Shared::smaller_first)
    return std::array{std::min(x.first[0], y.first[0]), std::min(x.first[1], y.first[1])};
  if (shared == Shared::last) return end;
  if (shared == Shared::of_a) return x.first;
  if (shared == Shared::of_b) return y.first;
  return begin;
}

}  // namespace cells_with_mistakes
