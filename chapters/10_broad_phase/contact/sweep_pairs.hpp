/// @file
/// Sort and sweep (sweep and prune): boxes are sorted along an axis, and only those that overlap on
/// it are compared; and an incremental version that reuses the order of the previous step.
#pragma once

#include <algorithm>
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
/// @param boxes n of them
/// @param axis 0, 1 or 2
/// @return between 0 and n (n − 1) / 2, in O(n log n)
template <Ring S>
std::uint64_t overlaps_on_axis(std::span<const Aabb<S>> boxes, int axis) {
  std::vector<S> lows;
  std::vector<S> highs;
  lows.reserve(boxes.size());
  highs.reserve(boxes.size());
  for (const Aabb<S>& box : boxes) {
    lows.push_back(box.low(axis));
    highs.push_back(box.high(axis));
  }
  std::sort(lows.begin(), lows.end());
  std::sort(highs.begin(), highs.end());
  std::uint64_t apart = 0;
  std::size_t ended = 0;
  for (const S& low : lows) {
    while (ended < highs.size() && highs[ended] < low) ++ended;
    apart += ended;
  }
  const std::uint64_t n = boxes.size();
  return n * (n - std::uint64_t{n > 0}) / 2 - apart;
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

/// Compares each box with those that begin before it ends.
template <Ring S>
void sweep_sorted(std::span<const Aabb<S>> boxes, std::span<const SweepStart<S>> sorted, int axis,
                  PairSearch& search) {
  for (std::size_t first = 0; first < sorted.size(); ++first) {
    const std::uint32_t i = sorted[first].box;
    const S& high = boxes[i].high(axis);
    for (std::size_t next = first + 1; next < sorted.size() && !(high < sorted[next].low); ++next)
      test_pair(boxes, i, sorted[next].box, search);
  }
  std::sort(search.pairs.begin(), search.pairs.end());
}

template <Ring S>
void sort_starts(std::vector<SweepStart<S>>& starts) {
  std::sort(starts.begin(), starts.end(), [](const auto& x, const auto& y) { return x.before(y); });
}

}  // namespace detail

// [sweep-pairs]
/// The pairs of boxes that touch, found by a sweep along an axis.
/// @param boxes n of them, at most 2^32 − 1
/// @param axis 0, 1 or 2
/// @return box_tests: overlaps_on_axis(boxes, axis), exactly
/// @see Cohen, Lin, Manocha and Ponamgi, *I-COLLIDE*, Symposium on Interactive 3D Graphics (1995)
template <Ring S>
PairSearch sweep_pairs(std::span<const Aabb<S>> boxes, int axis) {
  assert(axis >= 0 && axis < 3);
  std::vector<detail::SweepStart<S>> starts;
  const std::uint32_t n = detail::box_count(boxes);
  starts.reserve(n);
  for (std::uint32_t i = 0; i < n; ++i) starts.push_back({boxes[i].low(axis), i});
  detail::sort_starts(starts);
  PairSearch search;
  detail::sweep_sorted<S>(boxes, starts, axis, search);
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
  /// has changed.
  /// @param boxes in the same order as in the previous step
  /// @return box_tests: overlaps_on_axis(boxes, axis), exactly; other_steps: the number of pairs
  /// that exchanged their order, exactly, unless resorted()
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
  resorted_ = starts_.size() != boxes.size();
  if (resorted_) {
    starts_.clear();
    for (std::uint32_t i = 0; i < n; ++i) starts_.push_back({boxes[i].low(axis_), i});
  } else {
    for (auto& start : starts_) start.low = boxes[start.box].low(axis_);
  }
  const std::uint64_t max_moves = 4 * std::uint64_t{n} * std::bit_width(n);
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
  if (resorted_) detail::sort_starts(starts_);
  detail::sweep_sorted<S>(boxes, starts_, axis_, search);
  return search;
}
// [/incremental-sweep]

}  // namespace contact
