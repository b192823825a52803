/// @file
/// A tree of boxes for pairs of meshes: four boxes of floats in a node, and never a pair discarded
/// that touches.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <contact/aabb.hpp>
#include <contact/box_tree.hpp>
#include <contact/difference_determinant.hpp>
#include <contact/vector.hpp>
#include <contact/wide_line.hpp>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace contact::detail {

// [box-quad]
/// Four boxes and what is in them: of a leaf the positions of single items, otherwise nodes.
struct alignas(64) BoxQuad {
  FourBoxes planes;
  std::array<int, 4> below;
  float size = 0;  ///< of all four together, along the axis in which they are longest
  int count = 0;   ///< how many boxes are used
  bool is_leaf = false;
};
// [/box-quad]

/// The box around all four, four times.
inline FourBoxes around(const FourBoxes& boxes) {
  FourBoxes around;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& [low, high] = boxes;
    around[0][k].fill(std::min({low[k][0], low[k][1], low[k][2], low[k][3]}));
    around[1][k].fill(std::max({high[k][0], high[k][1], high[k][2], high[k][3]}));
  }
  return around;
}

/// A tree of such nodes over the positions of a BoxHierarchy. Its leaves have the boxes of items.
class BoxQuads {
 public:
  BoxQuads() = default;
  /// @param tree with at most four items in a leaf; not kept
  /// @param boxes of the items, by their numbers; not kept
  template <FloatOrDouble S>
  BoxQuads(const BoxHierarchy<S>& tree, std::span<const Aabb<S>> boxes) {
    if (tree.nodes.empty()) return;
    frame_ = WideFrame(tree.nodes[0].box);
    quads_.reserve(tree.nodes.size() * 2 / 3 + 1);
    add(tree, boxes, 0);
  }

  /// The root is number 0.
  const BoxQuad& operator[](int i) const { return quads_[static_cast<std::size_t>(i)]; }
  bool empty() const { return quads_.empty(); }
  const WideFrame& frame() const { return frame_; }

 private:
  WideFrame frame_;
  std::vector<BoxQuad> quads_;

  template <FloatOrDouble S>
  int add(const BoxHierarchy<S>& tree, std::span<const Aabb<S>> boxes, std::size_t root) {
    const std::size_t at = quads_.size();
    quads_.emplace_back();
    BoxQuad quad{no_boxes(), {}};
    if (const BoxNode<S>& node = tree.nodes[root]; node.count > 0) {
      quad.is_leaf = true;
      for (int i = node.first; i < node.first + node.count; ++i) {
        const int item = tree.order[static_cast<std::size_t>(i)];
        put(quad, boxes[static_cast<std::size_t>(item)], i);
      }
    } else {
      const Descendants below = four_descendants(tree, root, frame_.scale);
      for (std::size_t i = 0; i < below.count; ++i) {
        put(quad, tree.nodes[below.node[i]].box, add(tree, boxes, below.node[i]));
      }
    }
    const auto [low, high] = around(quad.planes);
    for (std::size_t k = 0; k < 3; ++k) quad.size = std::max(quad.size, high[k][0] - low[k][0]);
    quads_[at] = quad;
    return static_cast<int>(at);
  }
  template <FloatOrDouble S>
  void put(BoxQuad& quad, const Aabb<S>& box, int below) const {
    const auto i = static_cast<std::size_t>(quad.count++);
    frame_.put(quad.planes, i, box);
    quad.below[i] = below;
  }
};

// [quad-map]
/// Maps boxes from the frame of one tree to the frame of another of at least its size.
///
/// In the frame of the larger one a point is x · rate + D. The rate is a power of two, at most 1;
/// below 2^-100 it counts as that, which moves x by at most 2^-99. D is computed with two
/// roundings, and the halves lose at most 2^-1074 each, times a scale of at most 2^1000. Beyond
/// 2^60 the meshes are apart in any case. The lower and the upper planes are moved apart from D by
/// 2^-22 (2 + |D|). This is more than what is lost: 2^-24 of x · rate + D, which is at most 1.1 +
/// |D|, 2^-24 of |D| for its conversion to float, and the errors of D.
struct QuadMap {
  float rate = 1;
  std::array<std::array<float, 3>, 2> offset{};  ///< [low, high][axis]

  QuadMap(const WideFrame& from, const WideFrame& to) {
    rate = static_cast<float>(
        difference_detail::power_of_two(std::max(from.exponent - to.exponent, -100)));
    for (std::size_t k = 0; k < 3; ++k) {
      const int axis = static_cast<int>(k);
      const double half = from.centre[axis] / 2 - to.centre[axis] / 2;
      const double d = std::clamp(half * to.scale * 2, -0x1p60, 0x1p60);
      const double margin = 0x1p-22 * (2 + std::abs(d));
      offset[0][k] = static_cast<float>(d - margin);
      offset[1][k] = static_cast<float>(d + margin);
    }
  }
  /// Loops of four without a branch.
  FourBoxes operator()(const FourBoxes& boxes) const {
    FourBoxes mapped;
    for (std::size_t side = 0; side < 2; ++side) {
      for (std::size_t k = 0; k < 3; ++k) {
        const float by = offset[side][k];
        for (std::size_t i = 0; i < 4; ++i) mapped[side][k][i] = boxes[side][k][i] * rate + by;
      }
    }
    return mapped;
  }
};
// [/quad-map]

// [touching]
/// Which of four boxes touch box i of four others: bit j for box j. The least overlap along an axis
/// is not negative if they do. A difference of floats has the right sign.
inline unsigned touching(const FourBoxes& boxes, std::size_t i, const FourBoxes& others) {
  std::array<float, 4> overlap;
  for (std::size_t j = 0; j < 4; ++j) {
    const float x = others[1][0][j] - boxes[0][0][i], u = boxes[1][0][i] - others[0][0][j];
    const float y = others[1][1][j] - boxes[0][1][i], v = boxes[1][1][i] - others[0][1][j];
    const float z = others[1][2][j] - boxes[0][2][i], w = boxes[1][2][i] - others[0][2][j];
    const float xu = x < u ? x : u, yv = y < v ? y : v, zw = z < w ? z : w;
    const float xyuv = xu < yv ? xu : yv;
    overlap[j] = (xyuv < zw ? xyuv : zw) + 0.0f;  // −0 becomes 0
  }
  const auto bits = std::bit_cast<std::array<std::uint32_t, 4>>(overlap);
  const auto apart = [&bits](std::size_t j) { return bits[j] >> 31 << j; };
  return 15u & ~(apart(0) | apart(1) | apart(2) | apart(3));
}
// [/touching]

/// Calls each(i) for the bits of a number, from the lowest, until it returns true.
template <class Each>
bool each_bit(unsigned bits, const Each& each) {
  for (; bits != 0; bits &= bits - 1) {
    if (each(static_cast<std::size_t>(std::countr_zero(bits)))) return true;
  }
  return false;
}

/// Pairs of nodes that wait to be opened. The last one is next, as in every search in depth. But
/// each time that an eighth more leaves has been visited, it is one of the least depth, which is
/// large and far from there. So a search for any pair does not stay where there is none.
class WaitingPairs {
 public:
  struct Pair {
    int of_first, of_second;
    int depth;  ///< of pairs above it
  };
  bool empty() const { return pairs_.empty(); }
  void add(int of_first, int of_second, int depth) {
    pairs_.push_back({of_first, of_second, depth});
  }
  Pair take() {
    if (leaves_ >= next_change_) {
      next_change_ += 1 + leaves_ / 8;
      const auto shallow =
          std::min_element(pairs_.begin(), pairs_.end(),
                           [](const Pair& p, const Pair& q) { return p.depth < q.depth; });
      std::iter_swap(shallow, pairs_.end() - 1);
    }
    const Pair pair = pairs_.back();
    pairs_.pop_back();
    return pair;
  }
  /// Says that a pair of leaves was visited.
  void count_leaf() { ++leaves_; }

 private:
  std::vector<Pair> pairs_;
  std::size_t leaves_ = 0, next_change_ = 1;
};

/// The search of two trees, of which the second is not larger, or of one tree with itself.
template <class Visit>
class QuadSearch {
 public:
  QuadSearch(const BoxQuads& a, const BoxQuads& b, const Visit& visit)
      : a_(a), b_(b), map_(b.frame(), a.frame()), visit_(visit) {}

  bool run(std::size_t& compared) {
    waiting_.add(0, 0, 0);
    bool stopped = false;
    while (!stopped && !waiting_.empty()) stopped = open(waiting_.take());
    compared += compared_;
    return stopped;
  }

 private:
  const BoxQuads &a_, &b_;
  QuadMap map_;
  const Visit& visit_;
  WaitingPairs waiting_;
  std::size_t compared_ = 0;

  // [open]
  /// Opens the larger node, or both if they are of about the same size, and goes on with the boxes
  /// that touch. A leaf is not opened before the other node is a leaf too.
  bool open(const WaitingPairs::Pair& pair) {
    const BoxQuad &x = a_[pair.of_first], &y = b_[pair.of_second];
    const float size_of_y = y.size * map_.rate;
    const FourBoxes mapped = map_(y.planes);
    const bool opens_x = !x.is_leaf && (y.is_leaf || x.size * 2 >= size_of_y);
    const bool opens_y = !y.is_leaf && (x.is_leaf || size_of_y * 2 >= x.size);
    if (x.is_leaf && y.is_leaf) return visit_leaves(x, y, mapped);
    if (opens_x && opens_y) {
      compared_ += static_cast<std::size_t>(x.count * y.count);
      each_bit(all_touching(x, y, mapped), [&](std::size_t k) {
        waiting_.add(x.below[k / 4], y.below[k % 4], pair.depth + 1);
        return false;
      });
    } else if (opens_x) {
      compared_ += static_cast<std::size_t>(x.count);
      each_bit(touching(around(mapped), 0, x.planes), [&](std::size_t i) {
        waiting_.add(x.below[i], pair.of_second, pair.depth + 1);
        return false;
      });
    } else {
      compared_ += static_cast<std::size_t>(y.count);
      each_bit(touching(around(x.planes), 0, mapped), [&](std::size_t j) {
        waiting_.add(pair.of_first, y.below[j], pair.depth + 1);
        return false;
      });
    }
    return false;
  }
  bool visit_leaves(const BoxQuad& x, const BoxQuad& y, const FourBoxes& mapped) {
    waiting_.count_leaf();
    compared_ += static_cast<std::size_t>(x.count * y.count);
    return each_bit(all_touching(x, y, mapped),
                    [&](std::size_t k) { return visit_(x.below[k / 4], y.below[k % 4]); });
  }
  /// Bit 4 i + j for box i of x and box j of y. A node with itself: each pair once.
  unsigned all_touching(const BoxQuad& x, const BoxQuad& y, const FourBoxes& mapped) const {
    unsigned found = 0;
    for (std::size_t i = 0; i < 4; ++i) found |= touching(x.planes, i, mapped) << 4 * i;
    if (&x == &y) found &= x.is_leaf ? 0x08ceu : 0x8cefu;
    return found;
  }
  // [/open]
};

/// Calls visit(i, j) for the positions of each pair of items of two trees whose boxes touch, and
/// some that nearly do, until it returns true: a simultaneous traversal. A tree with itself: each
/// pair once.
///
/// It starts with both roots. If two boxes are apart, nothing below the one touches anything below
/// the other. If they touch, both are opened, and each box in one is compared with each in the
/// other, until two single items touch.
/// @param a,b not empty
/// @param compared the number of pairs of boxes compared is added to it
/// @return whether visit stopped
template <class Visit>
bool visit_touching(const BoxQuads& a, const BoxQuads& b, const Visit& visit,
                    std::size_t& compared) {
  if (a.frame().exponent >= b.frame().exponent) {
    return QuadSearch<Visit>(a, b, visit).run(compared);
  }
  const auto swapped = [&visit](int i, int j) { return visit(j, i); };
  return QuadSearch<decltype(swapped)>(b, a, swapped).run(compared);
}

}  // namespace contact::detail
