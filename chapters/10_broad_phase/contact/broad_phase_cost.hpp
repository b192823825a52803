/// @file
/// The cost of each broad phase before it runs: exact where possible, otherwise an expectation or a
/// bound, as each function says.
///
/// The unit of all costs is one comparison of two boxes.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <contact/grid_pairs.hpp>
#include <contact/sweep_pairs.hpp>
#include <contact/tree_pairs.hpp>

namespace contact {

/// The methods of the broad phase.
enum class BroadPhase { all_pairs, sweep, grid, tree };

// [box-profile]
/// The inputs of the cost model: number and extents of the boxes, and the range of their positions.
struct BoxProfile {
  std::uint64_t count = 0;  ///< n
  /// On each axis, the length of the range of the boxes' lower ends, m.
  Vector3<double> spread = Vector3<double>::Zero();
  Vector3<double> mean_extent = Vector3<double>::Zero();         ///< of high − low, m
  Vector3<double> mean_square_extent = Vector3<double>::Zero();  ///< of (high − low)², m²
  Vector3<double> largest_extent = Vector3<double>::Zero();      ///< of high − low, m
};

/// The profile of a list of boxes. Sums run in the order of the list.
/// @param boxes n of them, with extents whose squares do not overflow; n = 0 gives zeros
template <std::floating_point S>
BoxProfile profile_of(std::span<const Aabb<S>> boxes) {
  BoxProfile profile;
  profile.count = boxes.size();
  if (boxes.empty()) return profile;
  Vector3<double> least = boxes.front().low.template cast<double>();
  Vector3<double> most = least;
  for (const Aabb<S>& box : boxes) {
    const Vector3<double> low = box.low.template cast<double>();
    const Vector3<double> extent = box.high.template cast<double>() - low;
    least = least.cwiseMin(low);
    most = most.cwiseMax(low);
    profile.mean_extent += extent;
    profile.mean_square_extent += extent.cwiseProduct(extent);
    profile.largest_extent = profile.largest_extent.cwiseMax(extent);
  }
  profile.mean_extent /= double(boxes.size());
  profile.mean_square_extent /= double(boxes.size());
  profile.spread = most - least;
  return profile;
}
// [/box-profile]

/// The number of pairs of n things, n (n − 1) / 2: exactly the comparisons of all_pairs().
/// @param n at most 2^32
inline std::uint64_t pair_count(std::uint64_t n) {
  return n % 2 == 0 ? n / 2 * (n - std::uint64_t{n > 0}) : (n - 1) / 2 * n;
}

// [axis-share]
/// The expected fraction of pairs that overlap on an axis, if the lower ends are independent and
/// uniformly distributed over the spread.
///
/// With extents a and b and spread L, boxes with lower ends x and y overlap if −b ≤ x − y ≤ a. For
/// a ≤ L the part with x ≥ y has the probability q(a) = a/L − a²/(2 L²), for a larger a it is 1/2.
/// The mean of q(a) + q(b) over all pairs is twice the mean of q: 2 m₁/L − m₂/L², with m₁ and m₂
/// the means of the extent and of its square.
/// @return from 0 to 1. The expectation itself if no extent exceeds L. Otherwise 2 q(m₁), which is
/// not less, since q is concave (Jensen's inequality); at most 1
inline double expected_axis_share(const BoxProfile& profile, int axis) {
  const double length = profile.spread(axis);
  if (!(length > 0)) return 1;
  const double mean = profile.mean_extent(axis) / length;
  if (profile.largest_extent(axis) <= length)
    return std::min(1.0, 2 * mean - profile.mean_square_extent(axis) / length / length);
  return mean >= 1 ? 1 : mean * (2 - mean);
}

/// The expected number of comparisons of a sweep along the axis, under the assumptions of
/// expected_axis_share(). For a given list, overlaps_on_axis() is exact.
inline double expected_sweep_tests(const BoxProfile& profile, int axis) {
  return double(pair_count(profile.count)) * expected_axis_share(profile, axis);
}

/// The expected number of touching pairs. The expectation itself if all boxes have the same size,
/// which does not exceed the spread; otherwise an estimate, since large boxes are large on all
/// axes.
inline double expected_touching_pairs(const BoxProfile& profile) {
  double pairs = double(pair_count(profile.count));
  for (int axis = 0; axis < 3; ++axis) pairs *= expected_axis_share(profile, axis);
  return pairs;
}
// [/axis-share]

// [grid-bound]
/// An upper bound (not an estimate) on the comparisons of a grid for these boxes.
///
/// If the ranges of cells of two boxes meet on an axis, the boxes are less than a cell edge apart
/// on it, up to three roundings (of two differences and of the sum here), each of less than a 32nd
/// of the edge. So the pairs are among those that overlap on the axis when each box is extended by
/// 9/8 of an edge: this holds on all three axes, so the smallest of the three counts is a bound.
/// Boxes that cover many cells, and those that are none, are compared with all.
/// @param boxes n of them; those that are boxes with coordinates of less than 2^48 edges (2^19 in
/// float), and less than 2^20 edges from the grid's origin, none below it
/// @param grid whose edge is a power of two, made by grid_for()
template <std::floating_point S>
std::uint64_t max_grid_tests(std::span<const Aabb<S>> boxes, const PairGrid<S>& grid) {
  std::vector<Aabb<S>> longer(boxes.begin(), boxes.end());
  std::uint64_t large = 0;
  for (Aabb<S>& box : longer) {
    const bool compared_with_all =
        !detail::is_box(box) || detail::cells_of(box, grid).cells() > max_cells_of_a_box;
    if (compared_with_all) ++large;
    // What is no box would become one: then overlaps_on_axis() would count it again.
    for (int k = 0; k < 3 && !compared_with_all; ++k) box.high(k) += grid.cell_edge * S(9) / S(8);
  }
  std::uint64_t fewest = pair_count(boxes.size());
  for (int axis = 0; axis < 3; ++axis) fewest = std::min(fewest, overlaps_on_axis<S>(longer, axis));
  return std::min(pair_count(boxes.size()), fewest + large * boxes.size());
}

/// The expected number of comparisons of a grid, if the lower ends are independent and uniformly
/// distributed over the spread on each axis, and no box covers many cells: the pairs that are less
/// than an edge apart on all axes. An upper bound on the expectation if all boxes have the same
/// size; otherwise an estimate.
/// @param cell_edge m, greater than 0
inline double expected_grid_tests(const BoxProfile& profile, double cell_edge) {
  BoxProfile longer = profile;
  for (int axis = 0; axis < 3; ++axis) {
    const double mean = profile.mean_extent(axis);
    longer.mean_extent(axis) = mean + cell_edge;
    longer.mean_square_extent(axis) += cell_edge * (2 * mean + cell_edge);
    longer.largest_extent(axis) += cell_edge;
  }
  return expected_touching_pairs(longer);
}

/// The expected number of entries of all boxes in cells, if each had the mean extents and were
/// entered in all its cells: n Π (1 + extent / edge). The expectation itself if all boxes have the
/// same size, uniformly distributed positions on the grid, and at most max_cells_of_a_box cells;
/// boxes of more cells are not entered.
inline double expected_grid_entries(const BoxProfile& profile, double cell_edge) {
  double cells = double(profile.count);
  for (int axis = 0; axis < 3; ++axis) cells *= 1 + profile.mean_extent(axis) / cell_edge;
  return cells;
}
// [/grid-bound]

// [sampled-pairs]
/// An estimate of the number of pairs at most `margin` apart on all axes: up to 32 boxes, evenly
/// chosen from the list, are compared with all. Unlike an expectation over the spread, it sees
/// clusters. It is exact for at most 32 boxes and no margin; with one, each box is extended by
/// rounded sums, so pairs whose distance is within a few ulp of the margin may count half or not.
/// @param boxes n of them
/// @param margin m, not negative
template <std::floating_point S>
double sampled_pairs(std::span<const Aabb<S>> boxes, S margin) {
  const std::size_t n = boxes.size();
  const std::size_t samples = std::min<std::size_t>(n, 32);
  std::uint64_t met = 0;
  for (std::size_t k = 0; k < samples; ++k) {
    const std::size_t i = k * n / samples;
    Aabb<S> wide = boxes[i];
    for (int axis = 0; axis < 3; ++axis) {
      wide.low(axis) -= margin;
      wide.high(axis) += margin;
    }
    for (std::size_t j = 0; j < n; ++j) {
      if (j != i && boxes_touch(wide, boxes[j])) ++met;
    }
  }
  return samples == 0 ? 0 : double(met) * double(n) / double(2 * samples);
}
// [/sampled-pairs]

namespace detail {

/// How many cells two ranges have in common.
inline std::uint64_t common_cells(const CellRange& a, const CellRange& b) {
  std::uint64_t product = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t low = std::max(a.low[k], b.low[k]);
    const std::uint32_t high = std::min(a.high[k], b.high[k]);
    if (high < low) return 0;
    product *= std::uint64_t{high} - low + 1;
  }
  return product;
}

}  // namespace detail

// [cell-sample]
/// What the cells of a grid say about a list of boxes: entries are counted, and pairs estimated by
/// comparing up to 32 boxes with all.
struct CellSample {
  double entries = 0;     ///< exact: of boxes in cells, without those of many cells
  double many_cells = 0;  ///< exact: boxes of more than max_cells_of_a_box cells, or that are none
  double in_cells = 0;    ///< pairs whose ranges of cells overlap, without those of many cells
  double repeated = 0;    ///< how often these pairs meet in a further cell
  double touching = 0;    ///< pairs that touch
};

/// The sample is evenly chosen from the boxes of few cells. Their pairs with each other count half,
/// since each may be found from both sides; those with boxes of many cells count once, and the
/// latter are taken to touch each other. So one huge box that touches all or none of the others
/// changes the estimate by exactly its pairs, whether the sample would have met it or not; if it
/// touches some, they are estimated from the sample. Exact for at most 32 boxes of few cells and
/// one of many.
/// @param boxes n of them
/// @param grid any with a finite edge greater than 0
template <std::floating_point S>
CellSample sample_cells(std::span<const Aabb<S>> boxes, const PairGrid<S>& grid) {
  CellSample sample;
  std::vector<detail::CellRange> ranges;
  std::vector<std::size_t> few;
  std::vector<char> many;
  for (const Aabb<S>& box : boxes) {
    ranges.push_back(detail::cells_of(box, grid));
    many.push_back(!detail::is_box(box) || ranges.back().cells() > max_cells_of_a_box);
    if (many.back()) continue;
    sample.entries += double(ranges.back().cells());
    few.push_back(ranges.size() - 1);
  }
  sample.many_cells = double(boxes.size() - few.size());
  const std::size_t samples = std::min<std::size_t>(few.size(), 32);
  for (std::size_t k = 0; k < samples; ++k) {
    const std::size_t i = few[(2 * k + 1) * few.size() / (2 * samples)];
    for (std::size_t j = 0; j < boxes.size(); ++j) {
      if (j == i) continue;
      if (boxes_touch(boxes[i], boxes[j])) sample.touching += many[j] ? 1 : 0.5;
      const double cells = many[j] ? 0 : double(detail::common_cells(ranges[i], ranges[j]));
      if (cells > 0) sample.in_cells += 0.5;
      if (cells > 1) sample.repeated += (cells - 1) / 2;
    }
  }
  const double scale = samples == 0 ? 0 : double(few.size()) / double(samples);
  sample.in_cells *= scale;
  sample.repeated *= scale;
  sample.touching = sample.touching * scale + sample.many_cells * (sample.many_cells - 1) / 2;
  return sample;
}
// [/cell-sample]

// [broad-phase-cost]
/// The time of each method for a list of boxes. The unit is a comparison of two boxes in
/// all_pairs(), where the processor predicts its outcome: about 2 ns.
struct BroadPhaseCost {
  double all_pairs = 0;  ///< exact number of comparisons; estimates of wrong predictions and pairs
  double sweep = 0;      ///< the same, with sorting, n log₂ n
  double grid = 0;       ///< exact number of entries; the rest is an estimate
  double tree = 0;       ///< an estimate: a path to a leaf and back for each box and each pair

  /// The cheapest method; the first in the order of BroadPhase if several are.
  BroadPhase cheapest() const {
    const std::array<double, 4> all{all_pairs, sweep, grid, tree};
    const auto least = std::min_element(all.begin(), all.end());
    return static_cast<BroadPhase>(least - all.begin());
  }
};

/// The number of levels of sorting n things: the smallest integer k with n < 2^k.
inline double sorting_depth(std::uint64_t n) { return double(std::bit_width(n)); }

/// The cost of each method, for choosing one, in O(n log n).
///
/// The numbers of steps are counted, or estimated by sample_cells(); the weight of each kind of
/// step is fitted to times that were measured for 250 lists of 8 to 10,000 boxes (build/release,
/// AMD EPYC; benchmarks/broad_phase compares predictions with times). A comparison ends at the
/// first axis on which boxes are apart. If a fraction p of them goes on to the next axis, the
/// processor predicts at least min(p, 1 − p) of the outcomes wrongly, unless it finds a pattern.
/// @param boxes n of them
template <std::floating_point S>
BroadPhaseCost broad_phase_cost(std::span<const Aabb<S>> boxes) {
  const double n = double(boxes.size());
  const double pairs = double(pair_count(boxes.size()));
  std::array<double, 3> overlaps{};
  for (int axis = 0; axis < 3; ++axis)
    overlaps[static_cast<std::size_t>(axis)] = double(overlaps_on_axis(boxes, axis));
  const auto share = [&](std::size_t axis) { return pairs > 0 ? overlaps[axis] / pairs : 0; };
  const auto surprise = [](double p) { return std::min(p, 1 - p); };
  const CellSample cells = sample_cells(boxes, grid_for(boxes));
  const double sorting = n * sorting_depth(boxes.size());

  BroadPhaseCost cost;
  cost.all_pairs = pairs + 3.5 * (pairs * surprise(share(0)) + overlaps[0] * surprise(share(1))) +
                   0.5 * cells.touching;
  const auto best = static_cast<std::size_t>(std::min_element(overlaps.begin(), overlaps.end()) -
                                             overlaps.begin());
  cost.sweep = 11 * sorting + overlaps[best] * (0.5 + 5 * surprise(share(best == 0 ? 1 : 0))) +
               16.5 * cells.touching;
  cost.grid = 230 + 2 * n + 9 * cells.entries + 2.6 * (cells.in_cells + cells.many_cells * n) +
              4 * cells.repeated + 3 * cells.touching;
  cost.tree = 200 + 11.7 * sorting + 24 * cells.touching;
  return cost;
}

/// The pairs of boxes that touch, by the given method.
/// @param boxes n of them, as many as the method takes: at most 2^32 − 1 for all pairs and the
/// sweep, 2^26 for the grid, 2^30 for the tree
template <FloatOrDouble S>
PairSearch touching_pairs(std::span<const Aabb<S>> boxes, BroadPhase method) {
  switch (method) {
    case BroadPhase::sweep:
      return sweep_pairs(boxes);
    case BroadPhase::grid:
      return grid_pairs(boxes);
    case BroadPhase::tree:
      return tree_pairs(boxes);
    case BroadPhase::all_pairs:
      break;
  }
  return all_pairs(boxes);
}
// [/broad-phase-cost]

}  // namespace contact
