/// @file
/// A grid in a periodic space, where a box that leaves on one side enters on the other: each cell
/// has neighbours across the border, and with fewer than three cells along an axis fewer than 27.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <contact/box_pairs.hpp>
#include <contact/exact.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/outward.hpp>

namespace contact {

/// The most cells of a periodic grid along an axis.
inline constexpr std::uint32_t max_periodic_cells = 1u << 20;

// [periodic-grid]
/// Equal half-open cells in a space of which x and x + k period, for all integers k, are one point:
/// cell i of n along an axis holds the x with i period/n ≤ x − k period < (i + 1) period/n.
template <FloatOrDouble S>
struct PeriodicGrid {
  Vector3<S> period = Vector3<S>::Ones();       ///< m, finite and greater than 0
  std::array<std::uint32_t, 3> cells{1, 1, 1};  ///< from 1 to max_periodic_cells
};
// [/periodic-grid]

namespace detail {

/// Throws unless the period is finite and greater than 0 on each axis.
template <FloatOrDouble S>
void require_period(const Vector3<S>& period) {
  require_finite("period", period);
  if (!(period.minCoeff() > S(0)))
    throw_invalid_argument("period", vector_text(period), "must be greater than 0");
}

/// Throws unless each box is one, since what is not has no position in the period.
template <FloatOrDouble S>
void require_boxes(std::span<const Aabb<S>> boxes) {
  for (const Aabb<S>& box : boxes) {
    if (!is_box(box))
      throw_invalid_argument("boxes", vector_text(box.low), "must be finite, with low <= high");
  }
}

/// Whether a − b + m·period − extent ≤ 0, of stored numbers without rounding. The magnitudes of
/// four terms bound the four roundings of the sum; in doubt it is computed exactly.
inline bool within_extent(double a, double b, int m, double period, double high, double low) {
  const double shift = m * period;  // m is 0, ±1 or ±2: not rounded, but it may overflow
  const double difference = (a - b) + shift;
  const double extent = high - low;
  const double size = std::abs(a) + std::abs(b) + std::abs(shift) + std::abs(high) + std::abs(low);
  const double value = difference - extent;
  if (std::isfinite(size) && std::abs(value) > 0x1p-50 * size) return value < 0;
  const Exact sum = Exact(a) - Exact(b) + Exact(m) * Exact(period) - (Exact(high) - Exact(low));
  return sum.sign() <= 0;
}

}  // namespace detail

// [periodic-touch]
/// Whether two boxes have a point in common in the periodic space: whether a and b + k period touch
/// for some integer k on each axis. Exact for the stored numbers, also of boxes longer than the
/// period, which contain all of an axis.
///
/// With the lower ends a, b and extents e, f, that is −e ≤ a − b + k period ≤ f for some k. fmod()
/// is exact, so a and b can be reduced to less than a period; then a − b is less than two periods,
/// and an integer k within the limits exists only if one from −2 to 2 is: the interval contains 0,
/// and of its points a − b + k period the ones next to 0 have such a k.
/// @param period m, finite and greater than 0
/// @return false if a number is not finite, low > high, or the period is not greater than 0
template <FloatOrDouble S>
bool boxes_touch_periodic(const Aabb<S>& a, const Aabb<S>& b, const Vector3<S>& period) {
  if (!detail::is_box(a) || !detail::is_box(b) || !all_finite(period)) return false;
  for (int axis = 0; axis < 3; ++axis) {
    const double p = static_cast<double>(period[axis]);
    if (!(p > 0)) return false;
    const double a_low = static_cast<double>(a.low[axis]),
                 a_high = static_cast<double>(a.high[axis]);
    const double b_low = static_cast<double>(b.low[axis]),
                 b_high = static_cast<double>(b.high[axis]);
    const double x = std::fmod(a_low, p), y = std::fmod(b_low, p);
    bool touch = false;
    for (int k = -2; k <= 2 && !touch; ++k) {
      touch = detail::within_extent(x, y, k, p, b_high, b_low) &&
              detail::within_extent(y, x, -k, p, a_high, a_low);
    }
    if (!touch) return false;
  }
  return true;
}
// [/periodic-touch]

// [periodic-cell]
/// The cell along an axis that contains x: floor(x cells / period) modulo cells, exactly. For
/// every finite x, negative or many periods away, and for −0, which is in cell 0.
///
/// x is reduced to less than a period without rounding, by fmod(). The quotient, less than 2^20, is
/// then rounded twice, so it is off by less than 2^-30; closer than that to an integer, the floor
/// is decided exactly.
/// @param x m, finite; otherwise the cell is 0
/// @param period m, finite and greater than 0
/// @param cells from 1 to max_periodic_cells
template <FloatOrDouble S>
std::uint32_t periodic_cell(S x, S period, std::uint32_t cells) {
  if (!std::isfinite(x)) return 0;
  const double p = static_cast<double>(period);
  const double rest = std::fmod(static_cast<double>(x), p);
  const double quotient = rest / p * cells;
  double cell = std::floor(quotient);
  const double nearest = std::round(quotient);
  if (std::abs(quotient - nearest) < 0x1p-30) {
    const bool below = (Exact(rest) * Exact(cells) - Exact(nearest) * Exact(p)).sign() < 0;
    cell = below ? nearest - 1 : nearest;
  }
  if (cell < 0) cell += cells;
  return static_cast<std::uint32_t>(cell);
}
// [/periodic-cell]

// [periodic-neighbours]
/// The cells that are next to a cell along at most all three axes, and the cell itself: each once,
/// in increasing order.
///
/// These are 27 if each axis has at least three cells. With two, the neighbours on both sides are
/// the same cell, and with one they are the cell itself: counted without this, pairs would be
/// reported several times.
template <FloatOrDouble S>
std::vector<std::array<std::uint32_t, 3>> periodic_neighbours(
    const std::array<std::uint32_t, 3>& cell, const PeriodicGrid<S>& grid) {
  std::array<std::vector<std::uint32_t>, 3> along;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t n = grid.cells[k];
    along[k] = {cell[k] == 0 ? n - 1 : cell[k] - 1, cell[k], cell[k] + 1 == n ? 0 : cell[k] + 1};
    std::sort(along[k].begin(), along[k].end());
    along[k].erase(std::unique(along[k].begin(), along[k].end()), along[k].end());
  }
  std::vector<std::array<std::uint32_t, 3>> neighbours;
  for (const std::uint32_t x : along[0]) {
    for (const std::uint32_t y : along[1]) {
      for (const std::uint32_t z : along[2]) neighbours.push_back({x, y, z});
    }
  }
  return neighbours;
}
// [/periodic-neighbours]

/// The pairs of boxes that touch in the periodic space, by comparing each with each.
/// @param boxes n of them, at most 2^32 − 1
/// @param period m
/// @throws std::invalid_argument if the period is not finite or not greater than 0, or a box is not
/// finite or has low > high
template <FloatOrDouble S>
PairSearch periodic_all_pairs(std::span<const Aabb<S>> boxes, const Vector3<S>& period) {
  detail::require_period(period);
  detail::require_boxes(boxes);
  PairSearch search;
  const std::uint32_t n = detail::box_count(boxes);
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = i + 1; j < n; ++j) {
      ++search.box_tests;
      if (boxes_touch_periodic(boxes[i], boxes[j], period)) search.pairs.push_back({i, j});
    }
  }
  return search;
}

namespace detail {

/// Whether n boxes of an extent fit in the period, in which case the edge of one of n cells is not
/// shorter than the box. Certain if it says so: the product of a bound is rounded, so it must be
/// less, or it is compared exactly.
template <FloatOrDouble S>
bool fits_in_cell(S low, S high, S period, std::uint32_t cells) {
  const double extent = sum_up(static_cast<double>(high), -static_cast<double>(low));
  const double all = extent * cells;
  if (all != static_cast<double>(period)) return all < static_cast<double>(period);
  return (Exact(extent) * Exact(cells) - Exact(static_cast<double>(period))).sign() <= 0;
}

}  // namespace detail

// [periodic-grid-for]
/// A grid for the boxes: cells longer than all but the √n longest of n boxes, on each axis, if the
/// period permits, and not more of them than boxes.
/// @param boxes n of them, finite
/// @param period m
/// @throws std::invalid_argument as periodic_all_pairs()
template <FloatOrDouble S>
PeriodicGrid<S> periodic_grid_for(std::span<const Aabb<S>> boxes, const Vector3<S>& period) {
  detail::require_period(period);
  detail::require_boxes(boxes);
  PeriodicGrid<S> grid{period, {1, 1, 1}};
  if (boxes.empty()) return grid;
  // The cube root, which differs from library to library, rounded down.
  std::uint64_t most = 1;
  while ((most + 1) * (most + 1) * (most + 1) <= boxes.size()) ++most;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    std::vector<double> halves;  // halves cannot overflow
    halves.reserve(boxes.size());
    for (const Aabb<S>& box : boxes)
      halves.push_back(static_cast<double>(box.high[axis]) / 2 -
                       static_cast<double>(box.low[axis]) / 2);
    const auto longest = static_cast<std::size_t>(std::sqrt(static_cast<double>(boxes.size() - 1)));
    const std::size_t at = boxes.size() - 1 - longest;
    std::nth_element(halves.begin(), halves.begin() + static_cast<std::ptrdiff_t>(at),
                     halves.end());
    double fit = std::floor(static_cast<double>(period[axis]) / 2 / halves[at]);
    if (fit * halves[at] >= static_cast<double>(period[axis]) / 2) fit -= 1;
    const double cells = static_cast<double>(std::min<std::uint64_t>(most, max_periodic_cells));
    grid.cells[k] = fit >= cells ? static_cast<std::uint32_t>(cells)
                                 : static_cast<std::uint32_t>(std::max(1.0, fit));
  }
  return grid;
}
// [/periodic-grid-for]

// [periodic-grid-pairs]
/// The pairs of boxes that touch in the periodic space, found among neighbouring cells: the same as
/// those of periodic_all_pairs().
///
/// Each box is in the cell of its lower corner. If two boxes touch, their lower ends, shifted by a
/// multiple of the period, differ by at most an extent, on each axis; no extent exceeds the edge of
/// a cell, so the exact floors of the quotients differ by at most 1: the cells are neighbours. Two
/// neighbouring cells meet once, when the one with the smaller number is processed, because each
/// lists its neighbours once. A box that is longer than a cell is compared with all.
/// @param boxes n of them, at most 2^32 − 1
/// @param grid made by periodic_grid_for(), or any other
/// @return other_steps: neighbours looked up
/// @throws std::invalid_argument as periodic_all_pairs(), or if a number of cells is not from 1 to
/// max_periodic_cells
template <FloatOrDouble S>
PairSearch periodic_grid_pairs(std::span<const Aabb<S>> boxes, const PeriodicGrid<S>& grid) {
  detail::require_period(grid.period);
  detail::require_boxes(boxes);
  for (const std::uint32_t cells : grid.cells) {
    if (cells < 1 || cells > max_periodic_cells)
      throw_invalid_argument("cells", std::to_string(cells), "must be from 1 to 2^20");
  }
  struct Entry {
    std::array<std::uint32_t, 3> cell;
    std::uint32_t box;
    auto operator<=>(const Entry&) const = default;
  };
  std::vector<Entry> entries;
  std::vector<std::uint32_t> large;
  for (std::uint32_t i = 0; i < detail::box_count(boxes); ++i) {
    Entry entry{{}, i};
    bool fits = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      const S low = boxes[i].low[axis];
      entry.cell[k] = periodic_cell<S>(low, grid.period[axis], grid.cells[k]);
      fits = fits &&
             detail::fits_in_cell<S>(low, boxes[i].high[axis], grid.period[axis], grid.cells[k]);
    }
    if (fits) {
      entries.push_back(entry);
    } else {
      large.push_back(i);
    }
  }
  std::sort(entries.begin(), entries.end());
  PairSearch search;
  const auto test = [&](std::uint32_t i, std::uint32_t j) {
    ++search.box_tests;
    if (boxes_touch_periodic(boxes[i], boxes[j], grid.period))
      search.pairs.push_back({std::min(i, j), std::max(i, j)});
  };
  // [neighbouring-cells]
  for (auto first = entries.begin(); first != entries.end();) {
    auto last = first;
    while (last != entries.end() && last->cell == first->cell) ++last;
    for (const auto& cell : periodic_neighbours(first->cell, grid)) {
      if (cell < first->cell) continue;
      ++search.other_steps;
      auto other = std::lower_bound(first, entries.end(), Entry{cell, 0});
      for (; other != entries.end() && other->cell == cell; ++other) {
        for (auto one = first; one != (cell == first->cell ? other : last); ++one)
          test(one->box, other->box);
      }
    }
    first = last;
  }
  // [/neighbouring-cells]
  for (const std::uint32_t i : large) {
    for (std::uint32_t j = 0; j < detail::box_count(boxes); ++j) {
      if (j > i || !std::binary_search(large.begin(), large.end(), j)) {
        if (j != i) test(i, j);
      }
    }
  }
  detail::sort_pairs(search.pairs);
  return search;
}
// [/periodic-grid-pairs]

}  // namespace contact
