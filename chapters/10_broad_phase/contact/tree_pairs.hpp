/// @file
/// A bounding volume hierarchy (BVH): a tree of boxes, each of which encloses those below it. It is
/// the tree that meshes have, with bodies as items.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <contact/box_pairs.hpp>
#include <contact/box_tree.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/invalid_argument.hpp>

namespace contact {

// [box-tree]
/// A tree of boxes. If the box of a node touches nothing, no box below it does.
///
/// It is built by build_box_hierarchy(), the same for the same boxes, and at most 96 levels deep,
/// even if all boxes are at one position or on a line. One that is no box (not finite, or low >
/// high) is not in the tree, but compared with all.
template <FloatOrDouble S>
class BoxTree {
 public:
  /// The largest number of boxes in a leaf.
  static constexpr int leaf_size = 4;
  /// From this growth() on the tree counts as bad. It changes the cost only, never a result.
  static constexpr double max_growth = 2;

  /// @param boxes n of them, at most 2^30, so that fewer than 2^31 nodes are numbered; copied
  explicit BoxTree(std::span<const Aabb<S>> boxes);

  /// Moves the boxes and recomputes those of the nodes; the structure stays. The results are those
  /// of a new tree; what they cost, growth() estimates.
  /// @param boxes as many as before, in the same order
  /// @throws std::invalid_argument if their number is another
  void refit(std::span<const Aabb<S>> boxes);

  /// By which factor hierarchy_cost() has grown since the structure was made, at least 1: how many
  /// times as many nodes a cube of the mean size is expected to meet. Motion or scaling of all
  /// boxes together does not change it, up to rounding.
  /// @return infinite if all boxes were at one position and no longer are, or if it is no number
  double growth() const;
  /// Whether growth() has reached max_growth: then building a new tree is likely to pay. It may
  /// not, if the boxes have only become larger or crowded.
  bool is_bad() const { return !(growth() < max_growth); }

  /// The pairs that touch.
  /// @return box_tests: each pair of boxes at most once; other_steps: comparisons of two nodes
  PairSearch pairs() const;

  /// The indices of the boxes that touch a given one, in increasing order.
  /// @param counts if not null, comparisons with boxes and nodes are added to it, no pair
  std::vector<std::uint32_t> touching(const Aabb<S>& box, PairSearch* counts = nullptr) const;

  /// The tree; its items are the indices of the boxes.
  const BoxHierarchy<S>& hierarchy() const { return tree_; }

 private:
  std::vector<Aabb<S>> boxes_;
  BoxHierarchy<S> tree_;
  std::vector<Aabb<S>> ordered_;          // the boxes in the order of the tree
  std::vector<std::uint32_t> irregular_;  // those that are not in the tree
  double cost_ = 0;                       // hierarchy_cost() when the structure was made

  void build();
  void copy_in_order();
  void within(std::size_t node, PairSearch& search) const;
  void between(std::size_t one, std::size_t other, PairSearch& search) const;
  void test(int i, int j, PairSearch& search) const;
  static bool longer(const Aabb<S>& a, const Aabb<S>& b) {
    return (a.high / S(2) - a.low / S(2)).sum() > (b.high / S(2) - b.low / S(2)).sum();
  }
};
// [/box-tree]

template <FloatOrDouble S>
BoxTree<S>::BoxTree(std::span<const Aabb<S>> boxes) : boxes_(boxes.begin(), boxes.end()) {
  assert(boxes.size() <= std::size_t{1} << 30);
  build();
}

template <FloatOrDouble S>
void BoxTree<S>::build() {
  std::vector<int> items;
  items.reserve(boxes_.size());
  irregular_.clear();
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    if (detail::is_box(boxes_[i])) {
      items.push_back(static_cast<int>(i));
    } else {
      irregular_.push_back(static_cast<std::uint32_t>(i));
    }
  }
  tree_ = build_box_hierarchy<S>(boxes_, items, leaf_size);
  copy_in_order();
  cost_ = hierarchy_cost<S>(tree_, boxes_);
}

template <FloatOrDouble S>
void BoxTree<S>::copy_in_order() {
  ordered_.clear();
  ordered_.reserve(tree_.order.size());
  for (const int item : tree_.order) ordered_.push_back(boxes_[static_cast<std::size_t>(item)]);
}

// [refit]
template <FloatOrDouble S>
void BoxTree<S>::refit(std::span<const Aabb<S>> boxes) {
  if (boxes.size() != boxes_.size()) {
    throw_invalid_argument("boxes", std::to_string(boxes.size()) + " boxes",
                           "must be as many as in the tree, " + std::to_string(boxes_.size()));
  }
  boxes_.assign(boxes.begin(), boxes.end());
  std::size_t listed = 0;
  bool same_items = true;
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    const bool in_tree = listed >= irregular_.size() || irregular_[listed] != i;
    if (!in_tree) ++listed;
    same_items = same_items && in_tree == detail::is_box(boxes_[i]);
  }
  if (!same_items) return build();
  refit_box_hierarchy<S>(tree_, boxes_);
  copy_in_order();
}

template <FloatOrDouble S>
double BoxTree<S>::growth() const {
  const double now = hierarchy_cost<S>(tree_, boxes_);
  if (now <= cost_) return 1;
  const double factor = now / cost_;
  return std::isnan(factor) ? std::numeric_limits<double>::infinity() : factor;
}
// [/refit]

// [tree-descent]
/// Compares the items at two positions of the order.
template <FloatOrDouble S>
void BoxTree<S>::test(int i, int j, PairSearch& search) const {
  const Aabb<S>& a = ordered_[static_cast<std::size_t>(i)];
  const Aabb<S>& b = ordered_[static_cast<std::size_t>(j)];
  ++search.box_tests;
  if (!detail::overlap(a, b)) return;
  const auto x = static_cast<std::uint32_t>(tree_.order[static_cast<std::size_t>(i)]);
  const auto y = static_cast<std::uint32_t>(tree_.order[static_cast<std::size_t>(j)]);
  search.pairs.push_back({std::min(x, y), std::max(x, y)});
}

// [within-node]
// [within]
/// Pairs of two items below a node. Each pair has one node in whose leaf both are, or whose
/// children separate them, so it is met at most once.
template <FloatOrDouble S>
void BoxTree<S>::within(std::size_t node, PairSearch& search) const {
  const BoxNode<S>& self = tree_.nodes[node];
  const auto first = static_cast<std::size_t>(self.first);
  if (self.count == 0) {
    within(first, search);
    within(first + 1, search);
    return between(first, first + 1, search);
  }
  for (int i = self.first; i < self.first + self.count; ++i) {
    for (int j = i + 1; j < self.first + self.count; ++j) test(i, j, search);
  }
}
// [/within-node]

// [between-nodes]
// [/within]

/// Pairs of an item below one node and an item below another, which has none of the first.
template <FloatOrDouble S>
void BoxTree<S>::between(std::size_t one, std::size_t other, PairSearch& search) const {
  const BoxNode<S>& x = tree_.nodes[one];
  const BoxNode<S>& y = tree_.nodes[other];
  ++search.other_steps;
  if (!detail::overlap(x.box, y.box)) return;
  if (x.count > 0 && y.count > 0) {
    for (int i = x.first; i < x.first + x.count; ++i) {
      for (int j = y.first; j < y.first + y.count; ++j) test(i, j, search);
    }
  } else if (y.count > 0 || (x.count == 0 && longer(x.box, y.box))) {
    between(static_cast<std::size_t>(x.first), other, search);
    between(static_cast<std::size_t>(x.first) + 1, other, search);
  } else {
    between(one, static_cast<std::size_t>(y.first), search);
    between(one, static_cast<std::size_t>(y.first) + 1, search);
  }
}
// [/between-nodes]
// [/tree-descent]

template <FloatOrDouble S>
PairSearch BoxTree<S>::pairs() const {
  PairSearch search;
  if (!tree_.nodes.empty()) within(0, search);
  detail::test_with_all<S>(boxes_, irregular_, search);
  detail::sort_pairs(search.pairs);
  return search;
}

template <FloatOrDouble S>
std::vector<std::uint32_t> BoxTree<S>::touching(const Aabb<S>& box, PairSearch* counts) const {
  std::vector<std::uint32_t> found;
  std::size_t nodes = 0, items = irregular_.size();
  visit_box_hierarchy<S>(
      tree_, [&](const Aabb<S>& node) { return boxes_touch(node, box); },
      [&](int at) {
        const auto position = static_cast<std::size_t>(at);
        ++items;
        if (boxes_touch(ordered_[position], box))
          found.push_back(static_cast<std::uint32_t>(tree_.order[position]));
        return false;
      },
      &nodes);
  for (const std::uint32_t i : irregular_) {
    if (boxes_touch(boxes_[i], box)) found.push_back(i);
  }
  if (counts != nullptr) {
    counts->box_tests += items;
    counts->other_steps += nodes;
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// The pairs of boxes that touch, by a BoxTree built for this.
/// @param boxes n of them, at most 2^30
template <FloatOrDouble S>
PairSearch tree_pairs(std::span<const Aabb<S>> boxes) {
  return BoxTree<S>(boxes).pairs();
}

}  // namespace contact
