/// @file
/// Sweep and prune on three axes that keeps everything from step to step: the order of the ends,
/// and the pairs that touch. A step reads and writes all ends once; beyond that it costs what has
/// changed.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <contact/box_pairs.hpp>
#include <contact/sweep_pairs.hpp>

namespace contact {

namespace detail {

/// A beginning or an end of a box on an axis.
template <Ring S>
struct BoxEnd {
  static constexpr std::uint32_t upper = 1u << 31;
  S at;
  std::uint32_t key;  ///< the box, plus `upper` if it is the upper end

  bool ends() const { return key >= upper; }
  std::uint32_t box() const { return key & (upper - 1); }
  /// Of equal numbers beginnings come first, since touching counts; then the order of the list. So
  /// the order is strict, and does not depend on the past.
  bool before(const BoxEnd& other) const {
    return at < other.at || (at == other.at && key < other.key);
  }
};

}  // namespace detail

// [sweep-and-prune]
/// The pairs of boxes that touch, kept from step to step.
///
/// On each axis the ends of all boxes are sorted. Boxes overlap on an axis if and only if each
/// begins before the other ends, in this order. So a pair that touches now and did not before has a
/// beginning and an end that have exchanged their order on some axis. Insertion sort exchanges two
/// ends exactly if their order has changed, so it meets all these pairs: only they, and the pairs
/// of the previous step, are compared.
///
/// Source: Cohen, Lin, Manocha and Ponamgi, *I-COLLIDE*, Symposium on Interactive 3D Graphics
/// (1995).
template <Ring S>
class SweepAndPrune {
 public:
  /// The pairs that touch now: the same as those of all_pairs().
  ///
  /// The first time (unless the list is empty), if the number of boxes has changed, if one is no
  /// box (not finite, or low > high), or if sorting by insertion would take longer, it starts from
  /// scratch by sweep_pairs(), and resorted() says so.
  /// @param boxes n of them, at most 2^31 − 1, in the same order as in the previous step
  /// @return unless resorted(), box_tests: the pairs of the previous step, and on each axis the
  /// pairs of which a beginning has moved below an end; other_steps: exchanges of ends on all axes
  PairSearch update(std::span<const Aabb<S>> boxes);

  /// Whether the last update started from scratch.
  bool resorted() const { return resorted_; }

 private:
  using End = detail::BoxEnd<S>;
  std::array<std::vector<End>, 3> ends_;
  std::vector<BoxPair> pairs_;  // of the last step, in increasing order
  bool resorted_ = false;

  bool insert_sorted(std::vector<End>& ends, std::uint64_t max_moves, std::vector<BoxPair>& met,
                     std::uint64_t& moves) const;
  PairSearch start(std::span<const Aabb<S>> boxes);
};
// [/sweep-and-prune]

// [exchanges]
/// Sorts by insertion. Records each pair of boxes of which one's beginning moves below the other's
/// end: on this axis they did not overlap before. (The end that moves below a beginning separates
/// them, which a comparison of the kept pairs finds.)
/// @return false if it gave up after max_moves exchanges
template <Ring S>
bool SweepAndPrune<S>::insert_sorted(std::vector<End>& ends, std::uint64_t max_moves,
                                     std::vector<BoxPair>& met, std::uint64_t& moves) const {
  for (std::size_t k = 1; k < ends.size(); ++k) {
    if (!ends[k].before(ends[k - 1])) continue;
    const End moving = ends[k];
    const bool begins = !moving.ends();
    std::size_t place = k;
    for (; place > 0 && moving.before(ends[place - 1]); --place) {
      const End& passed = ends[place - 1];
      if (begins && passed.ends()) {
        const auto [a, b] = std::minmax({moving.box(), passed.box()});
        met.push_back({a, b});
      }
      ends[place] = passed;
      ++moves;
    }
    ends[place] = moving;
    if (moves > max_moves) return false;
  }
  return true;
}
// [/exchanges]

template <Ring S>
PairSearch SweepAndPrune<S>::start(std::span<const Aabb<S>> boxes) {
  resorted_ = true;
  PairSearch search = sweep_pairs(boxes);
  const bool sortable = std::all_of(boxes.begin(), boxes.end(), detail::is_box<S>);
  pairs_.clear();  // with no order, no pair is kept either
  if (sortable) pairs_ = search.pairs;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<End>& ends = ends_[static_cast<std::size_t>(axis)];
    ends.clear();
    if (!sortable) continue;
    ends.reserve(2 * boxes.size());
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      ends.push_back({boxes[i].low(axis), i});
      ends.push_back({boxes[i].high(axis), i + End::upper});
    }
    std::sort(ends.begin(), ends.end(), [](const End& x, const End& y) { return x.before(y); });
  }
  return search;
}

template <Ring S>
PairSearch SweepAndPrune<S>::update(std::span<const Aabb<S>> boxes) {
  const std::size_t n = detail::box_count(boxes);
  if (ends_[0].size() != 2 * n || !std::all_of(boxes.begin(), boxes.end(), detail::is_box<S>))
    return start(boxes);
  PairSearch search;
  std::vector<BoxPair> met;
  std::vector<S> now(2 * n);
  const std::uint64_t max_moves = 8 * std::uint64_t{n} * std::uint64_t(std::bit_width(n));
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<End>& ends = ends_[static_cast<std::size_t>(axis)];
    // All ends of the axis together: lower ones, then upper ones.
    for (std::size_t i = 0; i < n; ++i) {
      now[i] = boxes[i].low(axis);
      now[n + i] = boxes[i].high(axis);
    }
    for (End& end : ends) end.at = now[end.box() + (end.ends() ? n : 0)];
    if (!insert_sorted(ends, max_moves, met, search.other_steps)) return start(boxes);
  }
  resorted_ = false;
  for (const BoxPair& pair : pairs_) detail::test_pair(boxes, pair.a, pair.b, search);
  const auto kept = static_cast<std::ptrdiff_t>(search.pairs.size());
  for (const BoxPair& pair : met) detail::test_pair(boxes, pair.a, pair.b, search);
  // A pair that was met did not touch before, so it is not among the kept ones; it may have been
  // met on several axes.
  const auto fresh = search.pairs.begin() + kept;
  std::sort(fresh, search.pairs.end());
  search.pairs.erase(std::unique(fresh, search.pairs.end()), search.pairs.end());
  std::inplace_merge(search.pairs.begin(), search.pairs.begin() + kept, search.pairs.end());
  pairs_ = search.pairs;
  return search;
}

}  // namespace contact
