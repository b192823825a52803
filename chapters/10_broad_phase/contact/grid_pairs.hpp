/// @file
/// A uniform grid: only boxes that share a cell can touch.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <contact/box_pairs.hpp>

namespace contact {

// [pair-grid]
/// Cubic cells of one size that fill space from an origin. Coordinates outside the 2^21 cells of an
/// axis belong to the first or the last cell.
template <std::floating_point S>
struct PairGrid {
  Vector3<S> origin = Vector3<S>::Zero();  ///< a corner of the first cell, m
  S cell_edge = S(1);                      ///< m, finite and greater than 0
};

/// The index of the last cell along an axis.
inline constexpr std::uint32_t last_grid_cell = (1u << 21) - 1;

/// A box that covers more cells than this is not entered in cells, but compared with every box.
inline constexpr std::uint64_t max_cells_of_a_box = 64;

// [grid-cell]
/// The index of the cell along an axis that contains the coordinate x.
///
/// Difference and quotient are rounded, but each is monotonic, and so is the floor, which for
/// positive numbers is the conversion: x ≤ y implies cell(x) ≤ cell(y). The grid relies on nothing
/// else, so rounding moves the boundary of a cell but loses no pair.
/// @return 0 if x is NaN
template <std::floating_point S>
std::uint32_t grid_cell(S x, S origin, S cell_edge) {
  const S cell = (x - origin) / cell_edge;
  if (!(cell > S(0))) return 0;
  if (!(cell < S(last_grid_cell))) return last_grid_cell;
  return static_cast<std::uint32_t>(cell);
}
// [/grid-cell]
// [/pair-grid]

namespace detail {

/// The cells that a box covers: a range on each of three axes.
struct CellRange {
  std::array<std::uint32_t, 3> low;
  std::array<std::uint32_t, 3> high;

  std::uint64_t cells() const {
    std::uint64_t product = 1;
    for (std::size_t k = 0; k < 3; ++k) product *= std::uint64_t{high[k]} - low[k] + 1;
    return product;
  }
};

template <std::floating_point S>
CellRange cells_of(const Aabb<S>& box, const PairGrid<S>& grid) {
  CellRange range{};
  for (int k = 0; k < 3; ++k) {
    const auto axis = static_cast<std::size_t>(k);
    range.low[axis] = grid_cell(box.low(k), grid.origin(k), grid.cell_edge);
    range.high[axis] = grid_cell(box.high(k), grid.origin(k), grid.cell_edge);
  }
  return range;
}

/// Numbers the cells of a block, in as few bits as its size needs: in increasing order of x, then
/// y, then z.
struct CellBlock {
  std::array<std::uint32_t, 3> first{last_grid_cell, last_grid_cell, last_grid_cell};
  std::array<std::uint32_t, 3> last{0, 0, 0};

  void add(const CellRange& range) {
    for (std::size_t k = 0; k < 3; ++k) {
      first[k] = std::min(first[k], range.low[k]);
      last[k] = std::max(last[k], range.high[k]);
    }
  }
  int bits(std::size_t axis) const { return std::bit_width(last[axis] - first[axis]); }
  int bits() const { return bits(0) + bits(1) + bits(2); }
  std::uint64_t number(std::uint32_t x, std::uint32_t y, std::uint32_t z) const {
    const std::uint64_t xy = (std::uint64_t{x - first[0]} << bits(1)) | (y - first[1]);
    return (xy << bits(2)) | (z - first[2]);
  }
  /// The first cell common to two ranges that overlap.
  std::uint64_t first_common(const CellRange& a, const CellRange& b) const {
    return number(std::max(a.low[0], b.low[0]), std::max(a.low[1], b.low[1]),
                  std::max(a.low[2], b.low[2]));
  }
};

/// An entry of a box in a cell.
struct CellEntry {
  std::uint64_t cell;
  std::uint32_t box;
};

// [radix-sort]
/// Sorts entries by their cells, numbers of so many bits, and keeps the order of those of one cell:
/// radix sort, from the lowest digit to the highest. Each pass counts how often each digit occurs,
/// and so knows the position of each entry. A digit has about as many values as there are entries,
/// but from 16 to 4096, so this takes time linear in their number as long as the cells are not many
/// more.
inline void sort_by_cell(std::vector<CellEntry>& entries, int bits) {
  const int digit = std::clamp(int(std::bit_width(entries.size())), 4, 12);
  const std::uint64_t mask = (std::uint64_t{1} << digit) - 1;
  std::vector<CellEntry> sorted(entries.size());
  std::vector<std::uint32_t> position(mask + 2);
  for (int shift = 0; shift < bits; shift += digit) {
    std::fill(position.begin(), position.end(), 0);
    for (const CellEntry& entry : entries) ++position[((entry.cell >> shift) & mask) + 1];
    for (std::size_t k = 1; k < position.size(); ++k) position[k] += position[k - 1];
    for (const CellEntry& entry : entries) sorted[position[(entry.cell >> shift) & mask]++] = entry;
    entries.swap(sorted);
  }
}
// [/radix-sort]

/// The entries of all boxes except those listed, in the order of the cells, then of the boxes.
inline std::vector<CellEntry> entries_in_cells(std::span<const CellRange> ranges,
                                               std::span<const std::uint32_t> except,
                                               const CellBlock& block) {
  std::vector<CellEntry> entries;
  entries.reserve(2 * ranges.size());
  std::size_t excepted = 0;
  for (std::uint32_t i = 0; i < ranges.size(); ++i) {
    if (excepted < except.size() && except[excepted] == i) {
      ++excepted;
      continue;
    }
    const auto& [low, high] = ranges[i];
    for (std::uint32_t x = low[0]; x <= high[0]; ++x) {
      for (std::uint32_t y = low[1]; y <= high[1]; ++y) {
        for (std::uint32_t z = low[2]; z <= high[2]; ++z)
          entries.push_back({block.number(x, y, z), i});
      }
    }
  }
  if (!entries.empty()) sort_by_cell(entries, block.bits());
  return entries;
}

}  // namespace detail

// [grid-for]
namespace detail {

/// The edge of the cells for so many boxes: the smallest power of two that is at least twice the
/// median edge, with at most boxes + 1 cells in the whole range, and at most 2^21 along an axis:
/// coordinates beyond would all be in the last cell.
///
/// A range of length s has at most s / edge + 1 cells of a grid that begins where it begins. The
/// quotients are rounded, so all this holds up to a few ulp. It ends at the largest power of two
/// whose double is finite, whatever the boxes.
/// @param half_spread half of the range of all boxes, m, greater than 0 on an axis
/// @param half_median half of the median box's longest edge, m
template <std::floating_point S>
S cell_edge_for(const Vector3<S>& half_spread, S half_median, std::size_t boxes) {
  constexpr int most = std::numeric_limits<S>::max_exponent - 2;
  int power =
      std::max(std::ilogb(half_spread.maxCoeff()) - 32, std::numeric_limits<S>::min_exponent);
  const auto too_many = [&] {
    const S edge = std::ldexp(S(1), power);
    double cells = 1;
    for (int k = 0; k < 3; ++k) {
      const double along = 2 * double(half_spread(k) / edge);
      if (!(along < double(last_grid_cell) + 1)) return true;
      cells *= along + 1;
    }
    return cells > double(boxes) + 1;
  };
  const auto too_narrow = [&] { return std::ldexp(S(1), power) / S(4) < half_median; };
  while (power < most && (too_many() || too_narrow())) ++power;
  return std::ldexp(S(1), power);
}

}  // namespace detail

/// A grid for the boxes: cells at least twice as wide as the median box, and about as many as boxes
/// at most: one more, as for points at 0 and 2, or a few more where rounding decides.
///
/// The median is used because one huge body among small ones does not change it. The edge is a
/// power of two, and twice the median is meant up to the rounding of a box's edge. Without boxes,
/// or if all of them are points at one position, cells are 1 m wide.
///
/// Limits: the second condition counts cells of the whole range. One body far from the others, or
/// much larger than all of them together, makes the cells so long that most others share a few.
/// Where an edge of a quarter of the largest number is still too short, neither condition holds.
/// @param boxes n of them; those that are no boxes do not count
template <std::floating_point S>
PairGrid<S> grid_for(std::span<const Aabb<S>> boxes) {
  PairGrid<S> grid;
  Aabb<S> all;
  std::vector<S> halves;  // of each box's longest edge
  halves.reserve(boxes.size());
  for (const Aabb<S>& box : boxes) {
    if (!detail::is_box(box)) continue;
    all = halves.empty() ? box : enclosing_box(all, box);
    halves.push_back(Vector3<S>(box.high / S(2) - box.low / S(2)).maxCoeff());
  }
  if (halves.empty()) return grid;
  grid.origin = all.low;
  const auto middle = halves.begin() + static_cast<std::ptrdiff_t>(halves.size() / 2);
  std::nth_element(halves.begin(), middle, halves.end());
  const Vector3<S> half_spread = all.high / S(2) - all.low / S(2);
  if (half_spread.maxCoeff() > S(0))
    grid.cell_edge = detail::cell_edge_for<S>(half_spread, *middle, halves.size());
  return grid;
}
// [/grid-for]

// [grid-pairs]
/// The pairs of boxes that touch, found cell by cell.
///
/// Boxes that touch have a point in common, and the cell of that point is in the range of both. A
/// pair that shares several cells is tested only in the first of them, so at most once. The few
/// boxes that cover more than `max_cells_of_a_box` cells are compared with all.
/// @param boxes n of them, at most 2^26: with up to 64 entries each, every position in their list
/// is less than 2^32; one that is no box (not finite, or low > high) is compared with all
/// @param grid made by grid_for(), or any other with a finite edge greater than 0: the pairs are
/// the same, the cost is not
/// @return box_tests: the pairs whose ranges of cells overlap, and those with a box of many cells;
/// other_steps: entries in cells, and pairs found in a cell that is not their first
template <std::floating_point S>
PairSearch grid_pairs(std::span<const Aabb<S>> boxes, const PairGrid<S>& grid) {
  PairSearch search;
  const std::uint32_t n = detail::box_count(boxes);
  assert(n <= 1u << 26);
  std::vector<detail::CellRange> ranges;
  ranges.reserve(n);
  detail::CellBlock block;
  std::vector<std::uint32_t> large;
  for (std::uint32_t i = 0; i < n; ++i) {
    ranges.push_back(detail::cells_of(boxes[i], grid));
    if (!detail::is_box(boxes[i]) || ranges.back().cells() > max_cells_of_a_box) {
      large.push_back(i);
    } else {
      block.add(ranges.back());
    }
  }
  const auto entries = detail::entries_in_cells(ranges, large, block);
  search.other_steps = entries.size();
  // [cell-by-cell]
  for (std::size_t first = 0; first < entries.size(); ++first) {
    const auto [cell, i] = entries[first];
    for (std::size_t next = first + 1; next < entries.size() && entries[next].cell == cell;
         ++next) {
      const std::uint32_t j = entries[next].box;
      const bool first_here = block.first_common(ranges[i], ranges[j]) == cell;
      (first_here ? search.box_tests : search.other_steps) += 1;
      if ((int(first_here) & int(detail::overlap(boxes[i], boxes[j]))) != 0)
        search.pairs.push_back({std::min(i, j), std::max(i, j)});
    }
  }
  // [/cell-by-cell]
  detail::test_with_all<S>(boxes, large, search);
  detail::sort_pairs(search.pairs);
  return search;
}

/// The same with the grid of grid_for().
template <std::floating_point S>
PairSearch grid_pairs(std::span<const Aabb<S>> boxes) {
  return grid_pairs(boxes, grid_for(boxes));
}
// [/grid-pairs]

}  // namespace contact
