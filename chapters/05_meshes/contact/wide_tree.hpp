/// @file
/// A tree of boxes for lines: four boxes of floats in a node, tested together, and never a box
/// discarded that the line meets.
#pragma once

#include <array>
#include <bit>
#include <contact/box_tree.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/four_triangles.hpp>
#include <contact/vector.hpp>
#include <contact/wide_line.hpp>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace contact::detail {

// [wide-node]
/// Four boxes and what is in them.
struct alignas(64) WideNode {
  FourBoxes planes;
  std::array<int, 4> number;  ///< of a node or of a leaf
  std::array<int, 4> is_leaf;
};
// [/wide-node]

/// A tree of wide nodes over the positions of a BoxHierarchy, of which it shares the order.
class WideTree {
 public:
  WideTree() = default;
  /// @param tree with at most four triangles in a leaf; not kept
  /// @param triangles in the order of the tree; not kept
  template <FloatOrDouble S>
  WideTree(const BoxHierarchy<S>& tree, std::span<const Triangle<S>> triangles) {
    if (tree.nodes.empty()) return;
    frame_ = WideFrame(tree.nodes[0].box);
    nodes_.reserve(tree.nodes.size() / 4 + 1);
    leaves_.reserve(tree.nodes.size() / 2 + 1);
    add(tree, triangles, 0);
  }

  // [wide-walk]
  /// Calls leaf(triangles, last) for the leaves whose boxes the line meets, about in the order in
  /// which it enters them.
  /// @param leaf may decrease `last` to a τ after which nothing matters; returns whether to stop
  /// @param boxes the number of boxes tested is added to it if it is not null
  template <class Leaf>
  void walk(const WideLine& line, const Leaf& leaf, std::size_t* boxes) const {
    if (nodes_.empty() || line.misses) return;
    struct Child {
      float entry;
      int number;
      bool is_leaf;
    };
    std::array<Child, 3 * box_tree_depth + 4> waiting;
    std::size_t depth = 0;
    float last = line.last;
    Child at{0, 0, false};
    for (;;) {
      unsigned met = 0;
      if (at.is_leaf) {
        if (leaf(leaves_[static_cast<std::size_t>(at.number)], last)) return;
      } else {
        const WideNode& node = nodes_[static_cast<std::size_t>(at.number)];
        if (boxes != nullptr) *boxes += 4;
        alignas(16) std::array<float, 4> entry;
        met = met_boxes(node, line, last, entry);
        const auto next = [&] {
          const auto i = static_cast<std::size_t>(std::countr_zero(met));
          met &= met - 1;
          fetch(node.number[i], node.is_leaf[i] != 0);
          return Child{entry[i], node.number[i], node.is_leaf[i] != 0};
        };
        if (met != 0) {
          // The nearest is next. The others wait, the nearest of them last.
          at = next();
          const std::size_t from = depth;
          while (met != 0) {
            Child other = next();
            if (other.entry < at.entry) std::swap(other, at);
            std::size_t k = depth++;
            for (; k > from && waiting[k - 1].entry < other.entry; --k) waiting[k] = waiting[k - 1];
            waiting[k] = other;
          }
          continue;
        }
      }
      do {
        if (depth == 0) return;
        at = waiting[--depth];
      } while (at.entry > last);
    }
  }
  // [/wide-walk]

  const WideFrame& frame() const { return frame_; }

 private:
  WideFrame frame_;
  std::vector<WideNode> nodes_;
  std::vector<FourTriangles> leaves_;

  /// Asks the memory for what will soon be read.
  void fetch(int number, bool is_leaf) const {
    const auto i = static_cast<std::size_t>(number);
    const void* first = is_leaf ? static_cast<const void*>(&leaves_[i]) : &nodes_[i];
    const auto* bytes = static_cast<const char*>(first);
    __builtin_prefetch(bytes);
    __builtin_prefetch(bytes + 64);
    __builtin_prefetch(bytes + (is_leaf ? 128 : 64));
  }

  // [wide-times]
  /// Which of four boxes the line meets at τ ≤ last, bit i for box i, and their entries; loops of
  /// four without a branch. A difference of floats has the right sign.
  static unsigned met_boxes(const WideNode& node, const WideLine& line, float last,
                            std::array<float, 4>& entry) {
    constexpr float longer = 1 + 0x1p-20f;
    const auto& near_x = node.planes[line.near_side[0]][0];
    const auto& near_y = node.planes[line.near_side[1]][1];
    const auto& near_z = node.planes[line.near_side[2]][2];
    const auto& far_x = node.planes[1 - line.near_side[0]][0];
    const auto& far_y = node.planes[1 - line.near_side[1]][1];
    const auto& far_z = node.planes[1 - line.near_side[2]][2];
    const float nx = line.near_origin[0], ny = line.near_origin[1], nz = line.near_origin[2];
    const float fx = line.far_origin[0], fy = line.far_origin[1], fz = line.far_origin[2];
    const float ix = line.inverse[0], iy = line.inverse[1], iz = line.inverse[2];
    for (std::size_t i = 0; i < 4; ++i) {
      const float x = (near_x[i] - nx) * ix, y = (near_y[i] - ny) * iy, z = (near_z[i] - nz) * iz;
      const float xy = x > y ? x : y;
      const float z0 = z > 0 ? z : 0;
      entry[i] = xy > z0 ? xy : z0;
    }
    alignas(16) std::array<std::uint32_t, 4> room;
    for (std::size_t i = 0; i < 4; ++i) {
      const float x = (far_x[i] - fx) * ix, y = (far_y[i] - fy) * iy, z = (far_z[i] - fz) * iz;
      const float xy = x < y ? x : y;
      const float exit = (xy < z ? xy : z) * longer + 0x1p-120f;
      room[i] = std::bit_cast<std::uint32_t>((exit < last ? exit : last) - entry[i]);
    }
    const auto missed = [&room](std::size_t i) { return room[i] >> 31 << i; };
    return 15u & ~(missed(0) | missed(1) | missed(2) | missed(3));
  }
  // [/wide-times]

  /// Adds the node for four descendants of an inner node, or for a root that is a leaf.
  template <FloatOrDouble S>
  int add(const BoxHierarchy<S>& tree, std::span<const Triangle<S>> triangles, std::size_t root) {
    const Descendants below = four_descendants(tree, root, frame_.scale);
    const std::size_t at = nodes_.size();
    nodes_.emplace_back();
    WideNode node{no_boxes(), {}, {}};
    for (std::size_t i = 0; i < below.count; ++i) {
      const BoxNode<S>& child = tree.nodes[below.node[i]];
      frame_.put(node.planes, i, child.box);
      node.is_leaf[i] = child.count > 0;
      node.number[i] =
          child.count > 0 ? add_leaf(child, triangles) : add(tree, triangles, below.node[i]);
    }
    nodes_[at] = node;
    return static_cast<int>(at);
  }
  template <FloatOrDouble S>
  int add_leaf(const BoxNode<S>& node, std::span<const Triangle<S>> triangles) {
    FourTriangles& leaf = leaves_.emplace_back();
    leaf.first = node.first;
    leaf.count = node.count;
    for (std::size_t i = 0; i < static_cast<std::size_t>(node.count); ++i) {
      leaf.put(frame_, i, triangles[static_cast<std::size_t>(node.first) + i]);
    }
    return static_cast<int>(leaves_.size() - 1);
  }
};

}  // namespace contact::detail
