/// @file
/// A bounding volume hierarchy (BVH): a tree of boxes, each of which encloses those below it.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <contact/box_pairs.hpp>

namespace contact {

// [box-tree]
/// A tree of boxes. If the box of a node touches nothing, no box below it does.
///
/// The boxes of each node are split at the median of their centres, along the axis on which the
/// centres spread most. So the depth is at most log₂ n, even if all boxes are at one position or on
/// a line. The split does not depend on the standard library, because the order is strict: of equal
/// centres the one with the smaller index comes first.
template <std::floating_point S>
class BoxTree {
 public:
  /// The largest number of boxes in a leaf.
  static constexpr std::uint32_t leaf_size = 4;

  /// @param boxes n of them, at most 2^32 − 1; copied
  explicit BoxTree(std::span<const Aabb<S>> boxes) : boxes_(boxes.begin(), boxes.end()) {
    const std::uint32_t n = detail::box_count(boxes);
    order_.reserve(n);
    for (std::uint32_t i = 0; i < n; ++i) order_.push_back(i);
    if (n > 0) build(0, n);
  }

  /// The pairs that touch.
  /// @return box_tests: each pair of boxes at most once; other_steps: comparisons of two nodes
  PairSearch pairs() const {
    PairSearch search;
    if (!nodes_.empty()) within(0, search);
    std::sort(search.pairs.begin(), search.pairs.end());
    return search;
  }

  /// The indices of the boxes that touch a given one, in increasing order.
  std::vector<std::uint32_t> touching(const Aabb<S>& box) const {
    std::vector<std::uint32_t> found;
    if (!nodes_.empty()) collect(0, box, found);
    std::sort(found.begin(), found.end());
    return found;
  }

 private:
  struct Node {
    Aabb<S> box;
    std::uint32_t first;  // in order_
    std::uint32_t count;
    std::uint32_t right;  // node of the second half; the first half is the next node. 0 for a leaf
    bool leaf() const { return right == 0; }
  };

  std::vector<Aabb<S>> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;

  Vector3<S> centre(std::uint32_t box) const {
    return boxes_[box].low / S(2) + boxes_[box].high / S(2);
  }
  std::uint32_t build(std::uint32_t first, std::uint32_t count);
  void within(std::uint32_t node, PairSearch& search) const;
  void between(std::uint32_t one, std::uint32_t other, PairSearch& search) const;
  void collect(std::uint32_t node, const Aabb<S>& box, std::vector<std::uint32_t>& found) const;
};

template <std::floating_point S>
std::uint32_t BoxTree<S>::build(std::uint32_t first, std::uint32_t count) {
  const auto self = static_cast<std::uint32_t>(nodes_.size());
  Aabb<S> all = boxes_[order_[first]];
  Vector3<S> least = centre(order_[first]);
  Vector3<S> most = least;
  for (std::uint32_t k = first; k < first + count; ++k) {
    all = enclosing_box(all, boxes_[order_[k]]);
    const Vector3<S> c = centre(order_[k]);
    least = least.cwiseMin(c);
    most = most.cwiseMax(c);
  }
  nodes_.push_back({all, first, count, 0});
  if (count <= leaf_size) return self;
  const Vector3<S> half_spread = most / S(2) - least / S(2);
  int axis = 0;
  for (int k = 1; k < 3; ++k) {
    if (half_spread(k) > half_spread(axis)) axis = k;
  }
  const auto begin = order_.begin() + first;
  std::nth_element(begin, begin + count / 2, begin + count,
                   [this, axis](std::uint32_t i, std::uint32_t j) {
                     const S x = centre(i)(axis);
                     const S y = centre(j)(axis);
                     return x < y || (x == y && i < j);
                   });
  build(first, count / 2);
  const std::uint32_t right = build(first + count / 2, count - count / 2);
  nodes_[self].right = right;
  return self;
}

template <std::floating_point S>
void BoxTree<S>::within(std::uint32_t node, PairSearch& search) const {
  const Node& self = nodes_[node];
  if (!self.leaf()) {
    within(node + 1, search);
    within(self.right, search);
    between(node + 1, self.right, search);
    return;
  }
  for (std::uint32_t i = self.first; i < self.first + self.count; ++i) {
    for (std::uint32_t j = i + 1; j < self.first + self.count; ++j)
      detail::test_pair<S>(boxes_, order_[i], order_[j], search);
  }
}

template <std::floating_point S>
void BoxTree<S>::between(std::uint32_t one, std::uint32_t other, PairSearch& search) const {
  const Node& x = nodes_[one];
  const Node& y = nodes_[other];
  ++search.other_steps;
  if (!boxes_touch(x.box, y.box)) return;
  if (x.leaf() && y.leaf()) {
    for (std::uint32_t i = x.first; i < x.first + x.count; ++i) {
      for (std::uint32_t j = y.first; j < y.first + y.count; ++j)
        detail::test_pair<S>(boxes_, order_[i], order_[j], search);
    }
  } else if (y.leaf() || (!x.leaf() && x.count >= y.count)) {
    between(one + 1, other, search);
    between(x.right, other, search);
  } else {
    between(one, other + 1, search);
    between(one, y.right, search);
  }
}

template <std::floating_point S>
void BoxTree<S>::collect(std::uint32_t node, const Aabb<S>& box,
                         std::vector<std::uint32_t>& found) const {
  const Node& self = nodes_[node];
  if (!boxes_touch(self.box, box)) return;
  if (!self.leaf()) {
    collect(node + 1, box, found);
    collect(self.right, box, found);
    return;
  }
  for (std::uint32_t k = self.first; k < self.first + self.count; ++k) {
    if (boxes_touch(boxes_[order_[k]], box)) found.push_back(order_[k]);
  }
}
// [/box-tree]

/// The pairs of boxes that touch, by a BoxTree built for this.
/// @param boxes n of them, at most 2^32 − 1
template <std::floating_point S>
PairSearch tree_pairs(std::span<const Aabb<S>> boxes) {
  return BoxTree<S>(boxes).pairs();
}

}  // namespace contact
