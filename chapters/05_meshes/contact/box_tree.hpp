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
struct BoxTree {
  std::vector<BoxNode<S>> nodes;  ///< the root is nodes[0]; children follow their parent
  std::vector<int> order;         ///< the items; each leaf has a contiguous range
};
// [/box-node]

namespace detail {

/// The longest path from the root to a leaf is less than this.
inline constexpr int box_tree_depth = 96;

/// An item while the tree is built: its box in float, moved and scaled to about [−1, 1].
///
/// These numbers only choose where to split, so they need no bound. The nodes' boxes are made from
/// the boxes as given.
struct BuildItem {
  std::array<float, 3> low{}, high{};
  int item = 0;

  float twice_centre(std::size_t k) const { return low[k] + high[k]; }
};

/// A box in float that grows.
struct BuildBox {
  static constexpr float infinity = std::numeric_limits<float>::infinity();
  std::array<float, 3> low{infinity, infinity, infinity};
  std::array<float, 3> high{-infinity, -infinity, -infinity};

  template <class Box>
  void add(const Box& box) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], box.low[k]);
      high[k] = std::max(high[k], box.high[k]);
    }
  }
  /// Half of its surface; negative infinity, or NaN, for an empty box is never used.
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
    build(0, 0, static_cast<int>(items.size()), 0);
    tree_.order.reserve(items.size());
    for (const BuildItem& item : items_) tree_.order.push_back(item.item);
    enclose(boxes);
  }

  BoxTree<S> take() { return std::move(tree_); }

 private:
  static constexpr int bin_count = 16;
  /// From this depth on ranges are halved, so that no arrangement makes the tree deep: 2^32 items
  /// end 32 levels further down.
  static constexpr int halved_from = box_tree_depth - 34;

  struct Bin {
    BuildBox box;
    int count = 0;
  };
  struct Split {
    float cost = std::numeric_limits<float>::infinity();
    std::size_t axis = 0;
    int bin = 0;  ///< the first of the second half
  };
  /// Maps the centres of a range to bins.
  struct Binning {
    std::array<float, 3> from{}, scale{};

    Binning(const BuildBox& centres) {
      for (std::size_t k = 0; k < 3; ++k) {
        const float width = centres.high[k] - centres.low[k];
        from[k] = centres.low[k];
        scale[k] = width > 0x1p-100f ? bin_count * (1 - 0x1p-20f) / width : 0.0f;
      }
    }
    int bin(const BuildItem& item, std::size_t k) const {
      return static_cast<int>((item.twice_centre(k) - from[k]) * scale[k]);
    }
  };

  int max_leaf_;
  BoxTree<S> tree_;
  std::vector<BuildItem> items_;

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
    const int exponent = size > 0x1p-1000 ? std::ilogb(size) + 1 : -1000;
    const double scale = std::ldexp(1.0, -exponent);
    items_.reserve(items.size());
    for (const int item : items) {
      const Aabb<S>& box = box_of(item);
      BuildItem made;
      for (int k = 0; k < 3; ++k) {
        made.low[std::size_t(k)] = static_cast<float>((box.low(k) - centre(k)) * scale);
        made.high[std::size_t(k)] = static_cast<float>((box.high(k) - centre(k)) * scale);
      }
      made.item = item;
      items_.push_back(made);
    }
  }

  // [binned-split]
  /// The cheapest of the splits between bins: the sum over both halves of surface × number.
  Split best_split(int begin, int end, const Binning& binning) const {
    std::array<std::array<Bin, bin_count>, 3> bins;
    for (int i = begin; i < end; ++i) {
      const BuildItem& item = items_[static_cast<std::size_t>(i)];
      for (std::size_t k = 0; k < 3; ++k) {
        Bin& bin = bins[k][static_cast<std::size_t>(binning.bin(item, k))];
        bin.box.add(item);
        ++bin.count;
      }
    }
    Split best;
    for (std::size_t k = 0; k < 3; ++k) {
      std::array<float, bin_count> cost_after{};
      BuildBox box;
      int count = 0;
      for (std::size_t b = bin_count - 1; b > 0; --b) {
        box.add(bins[k][b].box);
        count += bins[k][b].count;
        cost_after[b] = count == 0 ? 0.0f : box.half_surface() * static_cast<float>(count);
      }
      box = BuildBox{};
      int before = 0;
      for (std::size_t b = 1; b < bin_count; ++b) {
        box.add(bins[k][b - 1].box);
        before += bins[k][b - 1].count;
        if (before == 0 || before == end - begin) continue;
        const float cost = box.half_surface() * static_cast<float>(before) + cost_after[b];
        if (cost < best.cost) best = {cost, k, static_cast<int>(b)};
      }
    }
    return best;
  }
  // [/binned-split]

  /// Makes a node of a range, and its children.
  void build(std::size_t node, int begin, int end, int depth) {
    const int count = end - begin;
    if (count == 1) return make_leaf(node, begin, count);
    BuildBox box, centres;
    for (int i = begin; i < end; ++i) {
      const BuildItem& item = items_[static_cast<std::size_t>(i)];
      box.add(item);
      for (std::size_t k = 0; k < 3; ++k) {
        centres.low[k] = std::min(centres.low[k], item.twice_centre(k));
        centres.high[k] = std::max(centres.high[k], item.twice_centre(k));
      }
    }
    const Binning binning(centres);
    const Split split = depth < halved_from ? best_split(begin, end, binning) : Split{};
    // A split costs as much as one item.
    if (count <= max_leaf_) {
      const float surface = box.half_surface();
      if (!(split.cost + surface < surface * static_cast<float>(count))) {
        return make_leaf(node, begin, count);
      }
    }
    int middle = begin + count / 2;
    if (split.cost < std::numeric_limits<float>::infinity()) {
      const auto first = items_.begin();
      middle = static_cast<int>(std::partition(first + begin, first + end,
                                               [&](const BuildItem& item) {
                                                 return binning.bin(item, split.axis) < split.bin;
                                               }) -
                                first);
    }
    const std::size_t children = tree_.nodes.size();
    tree_.nodes.resize(children + 2);
    tree_.nodes[node].first = static_cast<int>(children);
    build(children, begin, middle, depth + 1);
    build(children + 1, middle, end, depth + 1);
  }

  void make_leaf(std::size_t node, int begin, int count) {
    tree_.nodes[node].first = begin;
    tree_.nodes[node].count = count;
  }

  /// The boxes of the nodes, from the last to the first: children follow their parent.
  void enclose(std::span<const Aabb<S>> boxes) {
    for (std::size_t n = tree_.nodes.size(); n-- > 0;) {
      BoxNode<S>& node = tree_.nodes[n];
      const auto first = static_cast<std::size_t>(node.first);
      if (node.count == 0) {
        node.box = enclosing_box(tree_.nodes[first].box, tree_.nodes[first + 1].box);
        continue;
      }
      const auto box_at = [&](std::size_t i) -> const Aabb<S>& {
        return boxes[static_cast<std::size_t>(tree_.order[i])];
      };
      node.box = box_at(first);
      for (std::size_t i = 1; i < static_cast<std::size_t>(node.count); ++i) {
        node.box = enclosing_box(node.box, box_at(first + i));
      }
    }
  }
};

}  // namespace detail

// [build-box-tree]
/// Builds a tree of boxes. From the root down, each range of items is split between two of 16 bins
/// of their centres, along the axis and at the bin with the lowest sum of surface × number.
///
/// O(n log n) for all practical input; the depth is at most 96 for every input.
/// @param boxes made by the functions of aabb.hpp, finite
/// @param items which of the boxes: their numbers
/// @param max_leaf the most items of a leaf, at least 1
///
/// Source: Wald, *On Fast Construction of SAH-based Bounding Volume Hierarchies*, 2007.
template <FloatOrDouble S>
BoxTree<S> build_box_tree(std::span<const Aabb<S>> boxes, std::span<const int> items,
                          int max_leaf) {
  return detail::BoxTreeBuilder<S>(boxes, items, max_leaf).take();
}
// [/build-box-tree]

// [visit-tree]
/// Calls visit(position) for each position of the order in each leaf whose box, and all boxes above
/// it, `enters` accepts.
/// @param enters (const Aabb<S>&) → bool: whether what is below the box can matter
/// @param visit (int position) → bool: whether to stop
/// @param boxes if not null, the number of boxes asked is added to it
/// @return whether visit stopped
template <FloatOrDouble S, class Enters, class Visit>
bool visit_box_tree(const BoxTree<S>& tree, const Enters& enters, const Visit& visit,
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
