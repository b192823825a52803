/// @file
/// A binary tree of boxes, built by the surface area heuristic over binned centres.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <contact/aabb.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace contact {

// [box-node]
/// A node of a tree of boxes. An inner node has two children, stored next to each other.
template <FloatOrDouble S>
struct BoxNode {
  Aabb<S> box;    ///< contains all items below; nothing is rounded
  int first = 0;  ///< an inner node's first child; a leaf's first position in the order
  int count = 0;  ///< the number of items of a leaf; 0 for an inner node
};

/// A tree of boxes over items that are known by their numbers.
template <FloatOrDouble S>
struct BoxHierarchy {
  std::vector<BoxNode<S>> nodes;  ///< the root is nodes[0]; children follow their parent
  std::vector<int> order;         ///< the items; each leaf has a contiguous range
};
// [/box-node]

// [refit-box-tree]
/// Recomputes the boxes of a tree whose items have moved; its structure stays. From the last node
/// to the first: children follow their parent, so their boxes are ready when it needs them.
///
/// Each node's box is then the smallest one of the items below, as after building. So queries find
/// the same items; but the longer the items have moved, the more boxes overlap, and the more nodes
/// a query visits: hierarchy_cost() estimates it. An empty tree stays empty. If a box is not
/// finite, the boxes above it mean nothing.
/// @param boxes of all items, by their numbers
template <FloatOrDouble S>
void refit_box_hierarchy(BoxHierarchy<S>& tree, std::span<const Aabb<S>> boxes) {
  for (std::size_t n = tree.nodes.size(); n-- > 0;) {
    BoxNode<S>& node = tree.nodes[n];
    const auto first = static_cast<std::size_t>(node.first);
    if (node.count == 0) {
      node.box = enclosing_box(tree.nodes[first].box, tree.nodes[first + 1].box);
      continue;
    }
    const auto box_at = [&](std::size_t i) -> const Aabb<S>& {
      return boxes[static_cast<std::size_t>(tree.order[i])];
    };
    node.box = box_at(first);
    for (std::size_t i = 1; i < static_cast<std::size_t>(node.count); ++i) {
      node.box = enclosing_box(node.box, box_at(first + i));
    }
  }
}
// [/refit-box-tree]

namespace detail {

/// The longest path from the root to a leaf is less than this.
inline constexpr int box_tree_depth = 96;

/// Four floats, of which the last is not used: one instruction computes with all of them.
using FourFloats [[gnu::vector_size(16)]] = float;
using FourIntegers [[gnu::vector_size(16)]] = int;

/// A box while the tree is built, in float, moved and scaled to about [−1, 1].
///
/// These numbers only choose where to split, so they need no bound. The nodes' boxes are made from
/// the boxes as given.
struct alignas(16) BuildBox {
  static constexpr float infinity = std::numeric_limits<float>::infinity();
  FourFloats low{infinity, infinity, infinity, infinity};
  FourFloats high{-infinity, -infinity, -infinity, -infinity};

  void add(FourFloats lower, FourFloats upper) {
    low = lower < low ? lower : low;
    high = upper > high ? upper : high;
  }
  void add(const BuildBox& box) { add(box.low, box.high); }
  FourFloats twice_centre() const { return low + high; }
  /// Half of its surface; NaN for an empty box.
  float half_surface() const {
    const float x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
    return x * y + y * z + z * x;
  }
};

/// Builds the order and the tree's shape. Deterministic: the same boxes give the same tree.
template <FloatOrDouble S>
class BoxTreeBuilder {
 public:
  /// @param max_leaf the most items of a leaf
  BoxTreeBuilder(std::span<const Aabb<S>> boxes, std::span<const int> items, int max_leaf)
      : max_leaf_(max_leaf) {
    if (items.empty()) return;
    scale_items(boxes, items);
    tree_.nodes.reserve(items.size());
    tree_.nodes.push_back({});
    build(0, 0, items.size(), 0);
    refit_box_hierarchy(tree_, boxes);
  }

  BoxHierarchy<S> take() { return std::move(tree_); }

 private:
  static constexpr int max_bins = 16;
  /// From this depth on ranges are halved, so that no arrangement makes the tree deep: 2^32 items
  /// end 32 levels further down.
  static constexpr int halved_from = box_tree_depth - 34;

  struct Split {
    float cost = std::numeric_limits<float>::infinity();
    std::size_t axis = 0;
    int bin = 0;  ///< the first of the second half
  };
  /// Maps the centres of a range to bins: few for few items.
  struct Binning {
    int count;
    FourFloats from, scale;

    Binning(const BuildBox& centres, int items)
        : count(std::min(max_bins, 4 + items / 16)), from(centres.low) {
      for (std::size_t k = 0; k < 4; ++k) {
        const float width = centres.high[k] - centres.low[k];
        const float bins = static_cast<float>(count) * (1 - 0x1p-20f);
        scale[k] = width > 0x1p-100f ? bins / width : 0.0f;
      }
    }
    FourIntegers bins(const BuildBox& box) const {
      const FourFloats at = (box.twice_centre() - from) * scale;
      // 0 for NaN, so that also a box that is not finite has a bin.
      const FourFloats bin = at > 0 ? at : FourFloats{};
      return __builtin_convertvector(bin, FourIntegers);
    }
  };

  int max_leaf_;
  BoxHierarchy<S> tree_;
  std::vector<BuildBox> boxes_;  ///< of the items in the order of tree_.order

  void scale_items(std::span<const Aabb<S>> boxes, std::span<const int> items) {
    const auto box_of = [&](int item) -> const Aabb<S>& {
      return boxes[static_cast<std::size_t>(item)];
    };
    Aabb<S> all = box_of(items.front());
    for (const int item : items) all = enclosing_box(all, box_of(item));
    // Halves cannot overflow.
    const Vector3<double> low = all.low.template cast<double>() / 2;
    const Vector3<double> high = all.high.template cast<double>() / 2;
    const Vector3<double> centre = low + high;
    const double size = (high - low).maxCoeff();
    const int exponent = size > 0x1p-1000 && std::isfinite(size) ? std::ilogb(size) + 1 : -1000;
    const double scale = std::ldexp(1.0, -exponent);
    tree_.order.assign(items.begin(), items.end());
    boxes_.reserve(items.size());
    for (const int item : items) {
      const Aabb<S>& box = box_of(item);
      FourFloats lower{}, upper{};
      for (int k = 0; k < 3; ++k) {
        lower[std::size_t(k)] = static_cast<float>((box.low[k] - centre[k]) * scale);
        upper[std::size_t(k)] = static_cast<float>((box.high[k] - centre[k]) * scale);
      }
      boxes_.push_back({lower, upper});
    }
  }

  // [binned-split]
  /// The cheapest of the splits between bins: the sum over both halves of surface × number.
  Split best_split(std::size_t begin, std::size_t end, const Binning& binning) const {
    const auto bin_count = static_cast<std::size_t>(binning.count);
    std::array<std::array<BuildBox, max_bins>, 3> boxes;
    std::array<std::array<int, max_bins>, 3> counts;
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t b = 0; b < bin_count; ++b) {
        boxes[k][b] = BuildBox{};
        counts[k][b] = 0;
      }
    }
    for (std::size_t i = begin; i < end; ++i) {
      const BuildBox box = boxes_[i];
      const FourIntegers bins = binning.bins(box);
      for (std::size_t k = 0; k < 3; ++k) {
        const auto b = static_cast<std::size_t>(bins[k]);
        boxes[k][b].add(box);
        ++counts[k][b];
      }
    }
    Split best;
    const auto number = static_cast<int>(end - begin);
    for (std::size_t k = 0; k < 3; ++k) {
      if (counts[k][0] == number) continue;  // all in one bin
      std::array<float, max_bins> cost_after;
      BuildBox box;
      int count = 0;
      for (std::size_t b = bin_count - 1; b > 0; --b) {
        box.add(boxes[k][b]);
        count += counts[k][b];
        cost_after[b] = count == 0 ? 0.0f : box.half_surface() * static_cast<float>(count);
      }
      box = BuildBox{};
      count = 0;
      for (std::size_t b = 1; b < bin_count; ++b) {
        box.add(boxes[k][b - 1]);
        count += counts[k][b - 1];
        if (count == 0 || count == number) continue;
        const float cost = box.half_surface() * static_cast<float>(count) + cost_after[b];
        if (cost < best.cost) best = {cost, k, static_cast<int>(b)};
      }
    }
    return best;
  }
  // [/binned-split]

  /// Moves those in lower bins to the front; returns how many these are.
  std::size_t partition(std::size_t begin, std::size_t end, const Binning& binning,
                        const Split& split) {
    std::size_t middle = begin;
    for (std::size_t i = begin; i < end; ++i) {
      if (binning.bins(boxes_[i])[split.axis] >= split.bin) continue;
      std::swap(boxes_[i], boxes_[middle]);
      std::swap(tree_.order[i], tree_.order[middle]);
      ++middle;
    }
    return middle;
  }

  /// Makes a node of a range, and its children.
  void build(std::size_t node, std::size_t begin, std::size_t end, int depth) {
    const auto count = static_cast<int>(end - begin);
    if (count == 1) return make_leaf(node, begin, count);
    BuildBox box, centres;
    for (std::size_t i = begin; i < end; ++i) {
      const FourFloats centre = boxes_[i].twice_centre();
      box.add(boxes_[i]);
      centres.add(centre, centre);
    }
    const Binning binning(centres, count);
    const Split split = depth < halved_from ? best_split(begin, end, binning) : Split{};
    // A split costs as much as two items.
    if (count <= max_leaf_) {
      const float surface = box.half_surface();
      if (!(split.cost + 2 * surface < surface * static_cast<float>(count))) {
        return make_leaf(node, begin, count);
      }
    }
    std::size_t middle = begin + (end - begin) / 2;
    if (split.cost < BuildBox::infinity) middle = partition(begin, end, binning, split);
    const std::size_t children = tree_.nodes.size();
    tree_.nodes.resize(children + 2);
    tree_.nodes[node].first = static_cast<int>(children);
    build(children, begin, middle, depth + 1);
    build(children + 1, middle, end, depth + 1);
  }

  void make_leaf(std::size_t node, std::size_t begin, int count) {
    tree_.nodes[node].first = static_cast<int>(begin);
    tree_.nodes[node].count = count;
  }
};

}  // namespace detail

// [build-box-tree]
/// Builds a tree of boxes. From the root down, each range of items is split between two of up to 16
/// bins of their centres, along the axis and at the bin with the lowest sum of surface × number.
///
/// O(n log n) for all practical input; the depth is at most 96 for every input.
/// @param boxes made by the functions of aabb.hpp, finite
/// @param items which of the boxes: their numbers, at most 2^30
/// @param max_leaf the most items of a leaf, at least 1
/// @return without nodes if there are no items. If a box is not finite, each item is still in one
/// leaf, but the boxes above it mean nothing
///
/// Source: Wald, *On Fast Construction of SAH-based Bounding Volume Hierarchies*, 2007.
template <FloatOrDouble S>
BoxHierarchy<S> build_box_hierarchy(std::span<const Aabb<S>> boxes, std::span<const int> items,
                                    int max_leaf) {
  return detail::BoxTreeBuilder<S>(boxes, items, max_leaf).take();
}
// [/build-box-tree]

namespace detail {

/// Up to four nodes that have the same items as one.
struct Descendants {
  std::array<std::size_t, 4> node{};
  std::size_t count = 0;
};

/// The children of a node, of which that with the largest surface is replaced by its own, twice;
/// or the node itself if it is a leaf.
template <FloatOrDouble S>
Descendants four_descendants(const BoxHierarchy<S>& tree, std::size_t root, double scale) {
  Descendants below{{root}, 1};
  const auto surface = [&](std::size_t n) {
    const Aabb<S>& box = tree.nodes[n].box;  // halves cannot overflow
    const Vector3<double> size = (box.high / S(2) - box.low / S(2)).template cast<double>() * scale;
    return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
  };
  while (below.count < 4) {
    std::size_t widest = 4;
    double most = -1;
    for (std::size_t i = 0; i < below.count; ++i) {
      const std::size_t n = below.node[i];
      if (tree.nodes[n].count == 0 && surface(n) > most) {
        most = surface(n);
        widest = i;
      }
    }
    if (widest == 4) break;
    const auto child = static_cast<std::size_t>(tree.nodes[below.node[widest]].first);
    below.node[widest] = child;
    below.node[below.count++] = child + 1;
  }
  return below;
}

}  // namespace detail

// [hierarchy-cost]
/// How many nodes below the root a cube is expected to meet, rounded, if its centre is uniformly
/// distributed where it meets the root's box. After refitting, compare it with its value when the
/// tree was built.
///
/// A cube with the half edge t meets a box if its centre is in the box extended by t on all sides.
/// So of a node with half edges h in a root with half edges H the probability is the product of
/// (h + t) / (H + t) over the axes. Only quotients count, so it is the same at every scale. The
/// cube is as large as the items on average, and a little more, so that the cost of points on a
/// line or in a plane depends on their order too: t is the mean of all h of the items, plus the sum
/// of the H divided by the number of items.
/// @param boxes of all items, by their numbers, finite, in those of the nodes
/// @return from 0 to the number of nodes; 0 if the tree is empty, or if the root's box is a point
/// or smaller than numbers can be halved
template <FloatOrDouble S>
double hierarchy_cost(const BoxHierarchy<S>& tree, std::span<const Aabb<S>> boxes) {
  if (tree.nodes.empty()) return 0;
  // Halves do not overflow, and in units of the root's longest one none exceeds 1.
  const auto halves = [](const Aabb<S>& box) -> Vector3<double> {
    return box.high.template cast<double>() / 2 - box.low.template cast<double>() / 2;
  };
  const Vector3<double> root = halves(tree.nodes[0].box);
  const double unit = root.maxCoeff();
  if (!(unit > 0)) return 0;
  double sum = 0;
  for (const int item : tree.order) {
    const Vector3<double> half = halves(boxes[static_cast<std::size_t>(item)]) / unit;
    sum += (half[0] + half[1] + half[2]) / 3;
  }
  for (int k = 0; k < 3; ++k) sum += root[k] / unit;  // the sum of the three could overflow
  const double t = sum / static_cast<double>(tree.order.size());
  const auto extended = [&](const Vector3<double>& half) {
    return (half[0] / unit + t) * (half[1] / unit + t) * (half[2] / unit + t);
  };
  const double whole = extended(root);
  double cost = 0;
  for (std::size_t n = 1; n < tree.nodes.size(); ++n)
    cost += extended(halves(tree.nodes[n].box)) / whole;
  return cost;
}
// [/hierarchy-cost]

// [visit-tree]
/// Calls visit(position) for each position of the order in each leaf whose box, and all boxes above
/// it, `enters` accepts. Nothing is called for an empty tree. What a box with NaN means is left to
/// `enters`.
/// @param enters called with a box, an `Aabb<S>`; returns whether what is below it can matter
/// @param visit (int position) → bool: whether to stop
/// @param boxes if not null, the number of boxes asked is added to it
/// @return whether visit stopped
template <FloatOrDouble S, class Enters, class Visit>
bool visit_box_hierarchy(const BoxHierarchy<S>& tree, const Enters& enters, const Visit& visit,
                         std::size_t* boxes = nullptr) {
  if (tree.nodes.empty()) return false;
  if (boxes != nullptr) ++*boxes;
  if (!enters(tree.nodes[0].box)) return false;
  std::array<int, detail::box_tree_depth> waiting;
  std::size_t depth = 0;
  int at = 0;
  for (;;) {
    const BoxNode<S>& node = tree.nodes[static_cast<std::size_t>(at)];
    bool descends = false;
    if (node.count > 0) {
      for (int i = node.first; i < node.first + node.count; ++i) {
        if (visit(i)) return true;
      }
    } else {
      const auto first = static_cast<std::size_t>(node.first);
      if (boxes != nullptr) *boxes += 2;
      const bool left = enters(tree.nodes[first].box);
      const bool right = enters(tree.nodes[first + 1].box);
      if (left && right) waiting[depth++] = node.first + 1;
      descends = left || right;
      if (descends) at = left ? node.first : node.first + 1;
    }
    if (descends) continue;
    if (depth == 0) return false;
    at = waiting[--depth];
  }
}
// [/visit-tree]

}  // namespace contact
