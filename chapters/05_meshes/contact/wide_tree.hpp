/// @file
/// A tree of boxes for lines: four boxes of floats in a node, tested together, and never a box
/// discarded that the line meets.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <contact/box_tree.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/passage.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace contact {

namespace detail {

/// The planes of four boxes: [low, high][axis][box]. An empty box has low > high.
using FourBoxes = std::array<std::array<std::array<float, 4>, 3>, 2>;

/// Four empty boxes.
constexpr FourBoxes no_boxes() {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  FourBoxes boxes{};
  for (std::size_t k = 0; k < 3; ++k) {
    boxes[0][k] = {infinity, infinity, infinity, infinity};
    boxes[1][k] = {-infinity, -infinity, -infinity, -infinity};
  }
  return boxes;
}

// [wide-node]
/// Four boxes and what is in them.
struct alignas(64) WideNode {
  FourBoxes planes;
  std::array<int, 4> first;  ///< a node, or the first position of a leaf
  std::array<int, 4> count;  ///< positions in a leaf; 0 for a node
};
// [/wide-node]

/// The frame of a wide tree: x' = (x − centre) · scale, so that the root is in [−1, 1]. The scale
/// is a power of two.
struct WideFrame {
  Vector3<double> centre = Vector3<double>::Zero();
  double scale = 1;
  int exponent = 0;  ///< scale = 2^−exponent

  WideFrame() = default;
  template <FloatOrDouble S>
  explicit WideFrame(const Aabb<S>& root) {
    const Vector3<double> low = root.low.template cast<double>() / 2;
    const Vector3<double> high = root.high.template cast<double>() / 2;
    centre = low + high;
    const double size = (high - low).maxCoeff();
    // The centre is rounded, by as much as half of the size at most.
    exponent = size > 0 ? std::max(std::ilogb(size) + 2, -1000) : -1000;
    scale = std::ldexp(1.0, -exponent);
  }

  /// A plane in the frame, rounded to a float outwards: the value in double is off by u of itself,
  /// the float by another 2^-24.
  float outwards(double x, int k, int side) const {
    const double there = (x - centre[k]) * scale;
    return static_cast<float>(there + side * (0x1p-23 * std::abs(there) + 0x1p-80));
  }
  /// Writes a box as number i of four, rounded outwards.
  template <FloatOrDouble S>
  void put(FourBoxes& boxes, std::size_t i, const Aabb<S>& box) const {
    for (std::size_t k = 0; k < 3; ++k) {
      boxes[0][k][i] = outwards(box.low[int(k)], int(k), -1);
      boxes[1][k][i] = outwards(box.high[int(k)], int(k), 1);
    }
  }
};

// [wide-line]
/// A line in the frame of a wide tree, as x' = o' + τ d' with τ = t · rate − shift.
///
/// d' is the direction times a power of two, with its largest coordinate |d'_k| in [1, 2), and the
/// line starts at τ = 0 at the start or in front of the root, at most 8 from its centre in every
/// coordinate: if it is further, it misses the root. So within the root τ is at most 4, and
/// floats have errors of about 2^-22, whatever the distance of the start.
///
/// The margins. With O' the start in the frame, o' = O' + shift d' is computed in double from two
/// differences and a product, each rounded, and for a segment d' is a rounded difference: off by at
/// most 8 u (|O'| + |shift d'|), u = 2^-53. Two origins in float replace it, one on either side
/// of o' by more than that error and their own rounding: with the one the near planes cannot come
/// too late, with the other the far planes not too early. What remains are relative errors: 1.01 v
/// with v = 2^-24 of the inverse direction, v of the difference, v of the product. So entry ≤ exit
/// (1 + 3.1 v)/(1 − 3.1 v) if the line meets the box, and the factor 1 + 16 v covers that; 2^-120
/// covers underflow. A |d'_k| below 2^-100 counts as 2^-100: the origins are at least 2^-60 apart
/// from o', which is more than the line moves along k, so the slab keeps every line that is in it,
/// for all τ in the root, and no 0 · ∞ arises.
///
/// Source: Ize, *Robust BVH Ray Traversal*, Journal of Computer Graphics Techniques 2 (2013), for
/// the factor; the rest is needed because the boxes are in float and the start is moved.
struct WideLine {
  bool tame = false;    ///< whether the numbers are in a range for floats; else the tree is no help
  bool misses = false;  ///< whether it is certain that the line misses the root
  std::array<float, 3> near_origin{}, far_origin{}, inverse{};
  std::array<std::size_t, 3> near_side{};  ///< 0: the low plane is met first
  double rate = 0, shift = 0;
  float last = 0;  ///< no hit is beyond

  /// An upper bound of the τ of a hit with t ≤ latest.
  float after(double latest) const {
    const double at = latest * rate;
    const double tau = (at - shift) + 0x1p-50 * (at + shift);
    return tau < 8 ? static_cast<float>(std::max(tau, 0.0) * (1 + 0x1p-20) + 0x1p-60) : 8.0f;
  }
};

/// 2^k for |k| ≤ 1022.
inline double power_of_two(int k) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + k) << 52);
}

template <class Line>
WideLine wide_line(const Line& line, const WideFrame& frame) {
  WideLine wide;
  const Vector3<double> start = (start_of(line) - frame.centre) * frame.scale;
  Vector3<double> direction = ray_of(line).direction;
  const double longest = direction.cwiseAbs().maxCoeff();
  if (!(start.cwiseAbs().maxCoeff() < 0x1p40 && longest > 0x1p-1000 && longest < 0x1p1000)) {
    return wide;
  }
  const int exponent = std::ilogb(longest);
  if (std::abs(exponent - frame.exponent) > 1000) return wide;
  direction *= power_of_two(-exponent);
  wide.rate = power_of_two(exponent - frame.exponent);

  // The longest coordinate decides from where the line can be in the root: not before it is at −2
  // or 2, because from there to −1 or 1 is further than all errors.
  int k = 0;
  direction.cwiseAbs().maxCoeff(&k);
  const double entry = (direction[k] > 0 ? -2 - start[k] : 2 - start[k]) / direction[k];
  wide.shift = std::max(entry, 0.0);
  wide.tame = true;
  for (int i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double advance = wide.shift * direction[i];
    const double origin = start[i] + advance;
    const double error = 8 * 0x1p-53 * (std::abs(start[i]) + std::abs(advance));
    if (std::abs(origin) > 8) wide.misses = true;
    const double margin = 0x1p-22 * std::abs(origin) + 2 * error + 0x1p-59;
    const bool level = std::abs(direction[i]) < 0x1p-100;
    const bool forwards = level || direction[i] > 0;
    wide.near_side[at] = forwards ? 0 : 1;
    wide.near_origin[at] = static_cast<float>(forwards ? origin + margin : origin - margin);
    wide.far_origin[at] = static_cast<float>(forwards ? origin - margin : origin + margin);
    wide.inverse[at] = static_cast<float>(level ? 0x1p100 : 1 / direction[i]);
  }
  wide.last = has_end<Line> ? wide.after(1.0) : 8.0f;
  return wide;
}
// [/wide-line]

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

/// A tree of wide nodes over the positions of a BoxHierarchy, of which it shares the order.
class WideTree {
 public:
  WideTree() = default;
  /// @param tree not kept
  template <FloatOrDouble S>
  explicit WideTree(const BoxHierarchy<S>& tree) {
    if (tree.nodes.empty()) return;
    frame_ = WideFrame(tree.nodes[0].box);
    nodes_.reserve(tree.nodes.size() / 4 + 1);
    add(tree, 0);
  }

  // [wide-walk]
  /// Calls leaf(first, count, last) for the leaves whose boxes the line meets, about in the order
  /// in which it enters them.
  /// @param leaf may decrease `last` to a τ after which nothing matters; returns whether to stop
  /// @param boxes the number of boxes tested is added to it if it is not null
  template <class Leaf>
  void walk(const WideLine& line, const Leaf& leaf, std::size_t* boxes) const {
    if (nodes_.empty() || line.misses) return;
    struct Waiting {
      float entry;
      int first, count;
    };
    std::array<Waiting, 3 * box_tree_depth + 4> waiting;
    std::size_t depth = 0;
    float last = line.last;
    Waiting at{0, 0, 0};
    for (;;) {
      if (at.count > 0) {
        if (leaf(at.first, at.count, last)) return;
      } else {
        const WideNode& node = nodes_[static_cast<std::size_t>(at.first)];
        if (boxes != nullptr) *boxes += 4;
        alignas(16) std::array<float, 4> entry, exit;
        times(node, line, entry, exit);
        // Each box is written, and only those that are met stay: no branch to mispredict.
        const std::size_t from = depth;
        for (std::size_t i = 0; i < 4; ++i) {
          waiting[depth] = {entry[i], node.first[i], node.count[i]};
          depth += static_cast<std::size_t>(int(entry[i] <= exit[i]) & int(entry[i] <= last));
        }
        // The nearest last, so that it is taken first.
        for (std::size_t i = from + 1; i < depth; ++i) {
          const Waiting moved = waiting[i];
          std::size_t k = i;
          for (; k > from && waiting[k - 1].entry < moved.entry; --k) waiting[k] = waiting[k - 1];
          waiting[k] = moved;
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

  // [wide-times]
  /// The latest entry and the earliest exit of four boxes; loops of four without a branch.
  static void times(const WideNode& node, const WideLine& line, std::array<float, 4>& entry,
                    std::array<float, 4>& exit) {
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
    for (std::size_t i = 0; i < 4; ++i) {
      const float x = (far_x[i] - fx) * ix, y = (far_y[i] - fy) * iy, z = (far_z[i] - fz) * iz;
      const float xy = x < y ? x : y;
      exit[i] = (xy < z ? xy : z) * longer + 0x1p-120f;
    }
  }
  // [/wide-times]

  /// Adds the node for four descendants of an inner node.
  template <FloatOrDouble S>
  int add(const BoxHierarchy<S>& tree, std::size_t root) {
    const Descendants below = four_descendants(tree, root, frame_.scale);
    const std::size_t at = nodes_.size();
    nodes_.emplace_back();
    WideNode node{no_boxes(), {}, {}};
    for (std::size_t i = 0; i < below.count; ++i) {
      const BoxNode<S>& child = tree.nodes[below.node[i]];
      frame_.put(node.planes, i, child.box);
      node.count[i] = child.count;
      node.first[i] = child.count > 0 ? child.first : add(tree, below.node[i]);
    }
    nodes_[at] = node;
    return static_cast<int>(at);
  }
};

}  // namespace detail

}  // namespace contact
