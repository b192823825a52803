/// @file
/// Boxes of moving bodies: over a step, so that no contact within it is missed; and fat boxes with
/// a margin, which need no update until a body leaves its own.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <contact/box_pairs.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/moving_volumes.hpp>
#include <contact/outward.hpp>
#include <contact/tree_pairs.hpp>

namespace contact {

// [boxes-over-step]
/// For each body a box that contains it throughout a step, from its boxes at both ends.
///
/// Hypothesis: at each time a point of the body is at most `margin`, in each coordinate, from the
/// straight line between its positions at both ends. That is 0 for a body that translates at
/// constant velocity. It is sagitta() for one that also turns about a fixed axis at a constant
/// rate, by π or less in the step, about a point that moves straight at constant velocity; not for
/// one that turns further, since sagitta() knows the orientations at both ends only. The line is in
/// the box of both ends, which is convex. So bodies that touch at any time of the step have boxes
/// that touch; boxes may touch although the bodies pass the same position at different times.
/// @param start, end boxes of n bodies at both ends of the step, in the same order, m
/// @param margin m, not negative
/// @throws std::invalid_argument if the lists differ in length, one of them has what is no box (not
/// finite, or low > high), the margin is negative or not finite, or a box overflows
template <FloatOrDouble S>
std::vector<Aabb<S>> boxes_over_step(std::span<const Aabb<S>> start, std::span<const Aabb<S>> end,
                                     S margin = S(0)) {
  if (start.size() != end.size()) {
    throw_invalid_argument("end", std::to_string(end.size()) + " boxes",
                           "must be as many as at the start, " + std::to_string(start.size()));
  }
  std::vector<Aabb<S>> boxes;
  boxes.reserve(start.size());
  for (std::size_t i = 0; i < start.size(); ++i) {
    for (const Aabb<S>& box : {start[i], end[i]}) {
      if (!detail::is_box(box)) {
        throw_invalid_argument("box " + std::to_string(i),
                               vector_text(box.low) + " to " + vector_text(box.high),
                               "must be finite, with low <= high");
      }
    }
    boxes.push_back(aabb_of_motion<S>(start[i], end[i], margin));
  }
  return boxes;
}
// [/boxes-over-step]

/// Whether a box contains another, its faces included. Nothing is rounded.
/// @return false if a number is NaN
template <FloatOrDouble S>
bool box_contains(const Aabb<S>& outer, const Aabb<S>& inner) {
  for (int k = 0; k < 3; ++k) {
    if (!(outer.low(k) <= inner.low(k)) || !(inner.high(k) <= outer.high(k))) return false;
  }
  return true;
}

// [fat-box]
/// A box with a margin on all sides, rounded outwards. A face that would overflow is at the largest
/// number, so the result contains the box in every case.
/// @param box finite, with low ≤ high, m
/// @param margin m, finite and not negative
template <FloatOrDouble S>
Aabb<S> fat_box(const Aabb<S>& box, S margin) {
  constexpr S largest = std::numeric_limits<S>::max();
  Aabb<S> fat;
  for (int k = 0; k < 3; ++k) {
    fat.low(k) = std::max(-largest, sum_down(box.low(k), -margin));
    fat.high(k) = std::min(largest, sum_up(box.high(k), margin));
  }
  return fat;
}
// [/fat-box]

// [fat-box-pairs]
/// Keeps fat boxes of bodies from step to step, a tree of these, and their pairs.
///
/// The box of each body is in its fat box, so boxes that touch have fat boxes that touch: the pairs
/// to compare are among the kept ones. As long as no body leaves its fat box, a step compares only
/// these. A body that leaves gets a new fat box, and its pairs are looked up in the tree, whose
/// boxes are recomputed and whose structure stays until it has become bad.
template <FloatOrDouble S>
class FatBoxPairs {
 public:
  /// @param margin by which boxes are extended, m: a larger one is left later, and gives more pairs
  /// @throws std::invalid_argument if it is negative or not finite
  explicit FatBoxPairs(S margin) : margin_(margin) {
    require_finite("margin", margin);
    if (margin < S(0))
      throw_invalid_argument("margin", number_text(margin), "must not be negative");
  }

  /// The pairs that touch now: the same as those of all_pairs().
  /// @param boxes in the same order as in the previous step; if their number has changed, all is
  /// made anew. One that is no box (not finite, or low > high) is compared with all
  /// @return box_tests: comparisons of boxes: the kept pairs, and if fat boxes were renewed, those
  /// of fat boxes in the tree; other_steps: containments and nodes tested
  PairSearch update(std::span<const Aabb<S>> boxes);

  /// How many fat boxes the last update has renewed.
  std::size_t renewed() const { return renewed_; }
  /// The fat boxes, in the order of the bodies; of one that has never been a box, a point.
  std::span<const Aabb<S>> fat_boxes() const { return fat_; }
  /// The pairs of fat boxes that touch, in increasing order.
  std::span<const BoxPair> fat_pairs() const { return pairs_; }
  /// By how much boxes are extended, m.
  S margin() const { return margin_; }

 private:
  S margin_;
  std::vector<Aabb<S>> fat_;
  std::vector<BoxPair> pairs_;
  std::optional<BoxTree<S>> tree_;
  std::size_t renewed_ = 0;

  /// Renews the pairs of the marked ones.
  void renew_pairs(const std::vector<std::uint32_t>& left, PairSearch& search);
};
// [/fat-box-pairs]

template <FloatOrDouble S>
PairSearch FatBoxPairs<S>::update(std::span<const Aabb<S>> boxes) {
  PairSearch search;
  const std::uint32_t n = detail::box_count(boxes);
  const bool anew = fat_.size() != boxes.size();
  if (anew) {
    fat_.assign(boxes.size(), Aabb<S>{});
    pairs_.clear();
    tree_.reset();
  }
  // [leave-fat-box]
  std::vector<std::uint32_t> left, irregular;
  for (std::uint32_t i = 0; i < n; ++i) {
    ++search.other_steps;
    if (!detail::is_box(boxes[i])) {
      irregular.push_back(i);
    } else if (anew || !box_contains(fat_[i], boxes[i])) {
      fat_[i] = fat_box(boxes[i], margin_);
      left.push_back(i);
    }
  }
  renewed_ = left.size();
  if (anew || !left.empty()) renew_pairs(left, search);
  for (const BoxPair& pair : pairs_) {
    if (irregular.empty() || (detail::is_box(boxes[pair.a]) && detail::is_box(boxes[pair.b])))
      detail::test_pair(boxes, pair.a, pair.b, search);
  }
  // [/leave-fat-box]
  if (!irregular.empty()) {
    detail::test_with_all<S>(boxes, irregular, search);
    detail::sort_pairs(search.pairs);
  }
  return search;
}

template <FloatOrDouble S>
void FatBoxPairs<S>::renew_pairs(const std::vector<std::uint32_t>& left, PairSearch& search) {
  if (tree_) tree_->refit(fat_);
  if (!tree_ || tree_->is_bad() || 4 * left.size() > fat_.size()) {
    if (!tree_ || tree_->is_bad()) tree_.emplace(fat_);
    PairSearch all = tree_->pairs();
    search.box_tests += all.box_tests;
    search.other_steps += all.other_steps;
    pairs_ = std::move(all.pairs);
    return;
  }
  std::vector<char> renewed(fat_.size(), 0);
  for (const std::uint32_t i : left) renewed[i] = 1;
  std::erase_if(pairs_, [&](const BoxPair& pair) { return renewed[pair.a] || renewed[pair.b]; });
  const auto kept = static_cast<std::ptrdiff_t>(pairs_.size());
  for (const std::uint32_t i : left) {
    for (const std::uint32_t j : tree_->touching(fat_[i], &search)) {
      // Two renewed ones find each other twice; the smaller one reports the pair.
      if (j != i && (!renewed[j] || i < j)) pairs_.push_back({std::min(i, j), std::max(i, j)});
    }
  }
  std::sort(pairs_.begin() + kept, pairs_.end());
  std::inplace_merge(pairs_.begin(), pairs_.begin() + kept, pairs_.end());
}

}  // namespace contact
