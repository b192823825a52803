/// @file
/// Sort and sweep (sweep and prune): boxes are sorted along an axis, and only those that overlap on
/// it are compared; and an incremental version that reuses the order of the previous step.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <contact/box_pairs.hpp>

namespace contact {

// [overlaps-on-axis]
/// The number of pairs of boxes that overlap on one axis, touching included: exactly the
/// comparisons of a sweep along it, without making them.
///
/// A pair does not overlap if one box ends before the other begins. The lists of ends and of
/// beginnings are sorted, and one pass counts these pairs.
/// @param boxes n of them; those that are no boxes (not finite, or low > high) do not count
/// @param axis 0, 1 or 2
/// @return between 0 and n (n − 1) / 2, in O(n log n)
template <Ring S>
std::uint64_t overlaps_on_axis(std::span<const Aabb<S>> boxes, int axis) {
  std::vector<S> lows;
  std::vector<S> highs;
  lows.reserve(boxes.size());
  highs.reserve(boxes.size());
  for (const Aabb<S>& box : boxes) {
    if (!detail::is_box(box)) continue;
    lows.push_back(box.low(axis));
    highs.push_back(box.high(axis));
  }
  // [count-overlaps]
  std::sort(lows.begin(), lows.end());
  std::sort(highs.begin(), highs.end());
  std::uint64_t apart = 0;
  std::size_t ended = 0;
  for (const S& low : lows) {
    while (ended < highs.size() && highs[ended] < low) ++ended;
    apart += ended;
  }
  const std::uint64_t n = lows.size();
  return n * (n - std::uint64_t{n > 0}) / 2 - apart;
  // [/count-overlaps]
}

/// The axis on which the fewest pairs overlap; the first of several.
template <Ring S>
int best_sweep_axis(std::span<const Aabb<S>> boxes) {
  int best = 0;
  std::uint64_t fewest = overlaps_on_axis(boxes, 0);
  for (int axis = 1; axis < 3; ++axis) {
    const std::uint64_t overlaps = overlaps_on_axis(boxes, axis);
    if (overlaps < fewest) {
      best = axis;
      fewest = overlaps;
    }
  }
  return best;
}
// [/overlaps-on-axis]

namespace detail {

/// The beginning of a box on the axis of a sweep.
template <Ring S>
struct SweepStart {
  S low;
  std::uint32_t box;

  /// Boxes with equal beginnings are in the order of the list, so the order is unique.
  bool before(const SweepStart& other) const {
    return low < other.low || (!(other.low < low) && box < other.box);
  }
};

/// What a sweep compares, next to each other in the order of the sweep.
template <Ring S>
struct SweepBox {
  S low, high;                   // on the axis of the sweep
  std::array<S, 2> lows, highs;  // on the other two
  std::uint32_t box;
};

/// Compares each box with those that begin before it ends. These begin at or after its own
/// beginning and at or before its end, so they overlap on the axis; two axes remain.
template <Ring S>
void sweep_sorted(std::span<const Aabb<S>> boxes, std::span<const SweepStart<S>> sorted, int axis,
                  PairSearch& search) {
  std::vector<SweepBox<S>> line;
  line.reserve(sorted.size());
  const int y = (axis + 1) % 3, z = (axis + 2) % 3;
  for (const SweepStart<S>& start : sorted) {
    const auto& [low, high] = boxes[start.box];
    line.push_back({low(axis), high(axis), {low(y), low(z)}, {high(y), high(z)}, start.box});
  }
  // [sweep-in-order]
  for (std::size_t first = 0; first < line.size(); ++first) {
    const SweepBox<S>& one = line[first];
    std::size_t next = first + 1;
    for (; next < line.size() && !(one.high < line[next].low); ++next) {
      const SweepBox<S>& other = line[next];
      const int apart = int(one.highs[0] < other.lows[0]) | int(other.highs[0] < one.lows[0]) |
                        int(one.highs[1] < other.lows[1]) | int(other.highs[1] < one.lows[1]);
      if (apart == 0)
        search.pairs.push_back({std::min(one.box, other.box), std::max(one.box, other.box)});
    }
    search.box_tests += next - first - 1;
  }
  // [/sweep-in-order]
}

template <Ring S>
void sort_starts(std::vector<SweepStart<S>>& starts) {
  std::sort(starts.begin(), starts.end(), [](const auto& x, const auto& y) { return x.before(y); });
}

}  // namespace detail

// [sweep-pairs]
/// The pairs of boxes that touch, found by a sweep along an axis.
/// @param boxes n of them, at most 2^32 − 1; one that is no box (not finite, or low > high) is
/// compared with all
/// @param axis 0, 1 or 2
/// @return box_tests: overlaps_on_axis(boxes, axis), exactly, if all are boxes
/// @see Cohen, Lin, Manocha and Ponamgi, *I-COLLIDE*, Symposium on Interactive 3D Graphics (1995)
template <Ring S>
PairSearch sweep_pairs(std::span<const Aabb<S>> boxes, int axis) {
  assert(axis >= 0 && axis < 3);
  std::vector<detail::SweepStart<S>> starts;
  const std::uint32_t n = detail::box_count(boxes);
  starts.reserve(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    if (detail::is_box(boxes[i])) starts.push_back({boxes[i].low(axis), i});
  }
  detail::sort_starts(starts);
  PairSearch search;
  detail::sweep_sorted<S>(boxes, starts, axis, search);
  if (starts.size() < boxes.size()) detail::test_irregular(boxes, search);
  detail::sort_pairs(search.pairs);
  return search;
}

/// The same along the axis of best_sweep_axis().
template <Ring S>
PairSearch sweep_pairs(std::span<const Aabb<S>> boxes) {
  return sweep_pairs(boxes, best_sweep_axis(boxes));
}
// [/sweep-pairs]

// [incremental-sweep]
/// A sweep that keeps its order from step to step.
///
/// If bodies have moved a little, the old order is almost sorted, and insertion sort needs as many
/// moves as pairs have exchanged their order: n steps if none has. The sorted order is unique, so
/// it does not depend on the previous steps.
template <Ring S>
class IncrementalSweep {
 public:
  /// @param axis 0, 1 or 2
  explicit IncrementalSweep(int axis) : axis_(axis) { assert(axis >= 0 && axis < 3); }

  /// The pairs that touch now.
  ///
  /// If the order has changed so much that insertion sort would take longer than sorting from
  /// scratch, it sorts from scratch, and resorted() says so. It does so too if the number of boxes
  /// has changed, or one is no box.
  /// @param boxes in the same order as in the previous step
  /// @return box_tests: overlaps_on_axis(boxes, axis), exactly, if all are boxes; other_steps: the
  /// number of pairs that exchanged their order, exactly, unless resorted()
  PairSearch update(std::span<const Aabb<S>> boxes);

  /// Whether the last update sorted from scratch.
  bool resorted() const { return resorted_; }
  /// The axis of the sweep.
  int axis() const { return axis_; }

 private:
  int axis_;
  bool resorted_ = false;
  std::vector<detail::SweepStart<S>> starts_;
};

template <Ring S>
PairSearch IncrementalSweep<S>::update(std::span<const Aabb<S>> boxes) {
  PairSearch search;
  const std::uint32_t n = detail::box_count(boxes);
  if (!std::all_of(boxes.begin(), boxes.end(), detail::is_box<S>)) {
    starts_.clear();
    resorted_ = true;
    return sweep_pairs(boxes, axis_);
  }
  resorted_ = starts_.size() != boxes.size();
  if (resorted_) {
    starts_.clear();
    for (std::uint32_t i = 0; i < n; ++i) starts_.push_back({boxes[i].low(axis_), i});
  } else {
    for (auto& start : starts_) start.low = boxes[start.box].low(axis_);
  }
  const std::uint64_t max_moves = 4 * std::uint64_t{n} * std::bit_width(n);
  // [insertion-sort]
  for (std::size_t k = 1; k < starts_.size() && !resorted_; ++k) {
    const detail::SweepStart<S> moving = starts_[k];
    std::size_t place = k;
    for (; place > 0 && moving.before(starts_[place - 1]); --place) {
      starts_[place] = starts_[place - 1];
      ++search.other_steps;
    }
    starts_[place] = moving;
    resorted_ = search.other_steps > max_moves;
  }
  // [/insertion-sort]
  if (resorted_) detail::sort_starts(starts_);
  detail::sweep_sorted<S>(boxes, starts_, axis_, search);
  detail::sort_pairs(search.pairs);
  return search;
}
// [/incremental-sweep]

}  // namespace contact
