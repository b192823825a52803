/// @file
/// Pairs of boxes that touch, by comparing all or by a sweep with one mistake that people make:
/// what the test of the exercise compares with and recognises.
#pragma once

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <vector>

#include "sort_and_sweep.hpp"

namespace sweep_with_mistakes {

using exercise::Box;
using exercise::Swept;

inline const Box& at(const std::vector<Box>& boxes, int i) {
  return boxes[static_cast<std::size_t>(i)];
}

// ---------------------------------------------------------------- the order

/// By which numbers boxes are sorted.
enum class Order { rightly, not_at_all, along_y, by_ends, larger_first, ties_by_ends };

inline std::vector<int> order_along_x(const std::vector<Box>& boxes, Order how = Order::rightly) {
  std::vector<int> order(boxes.size());
  std::iota(order.begin(), order.end(), 0);
  if (how == Order::not_at_all) return order;
  const auto key = [&](int i) {
    const Box& box = at(boxes, i);
    if (how == Order::along_y) return std::pair(box.low.y(), 0.0);
    if (how == Order::by_ends) return std::pair(box.high.x(), 0.0);
    return std::pair(box.low.x(), how == Order::ties_by_ends ? box.high.x() : 0.0);
  };
  std::stable_sort(order.begin(), order.end(), [&](int i, int j) {
    if (key(i) != key(j)) return key(i) < key(j);
    return how == Order::larger_first && i > j;
  });
  return order;
}

// ---------------------------------------------------------------- the pairs

inline bool meet(const Box& a, const Box& b, int axis) {
  return a.low[axis] <= b.high[axis] && b.low[axis] <= a.high[axis];
}

/// What is right, without any order.
inline Swept all_pairs(const std::vector<Box>& boxes) {
  Swept swept{{}, 0};
  for (int i = 0; i < std::ssize(boxes); ++i) {
    for (int j = i + 1; j < std::ssize(boxes); ++j) {
      if (!meet(at(boxes, i), at(boxes, j), 0)) continue;
      ++swept.compared;
      if (meet(at(boxes, i), at(boxes, j), 1)) swept.touching.push_back({i, j});
    }
  }
  return swept;
}

/// What a sweep does wrong.
struct Ways {
  Order order = Order::rightly;
  bool ends_missed = false;       ///< an end and a start at the same x are apart
  bool y_missed = false;          ///< and along y
  bool next_alone = false;        ///< each box is compared with the next one only
  bool stops_early = false;       ///< after the first box that does not touch
  bool x_alone = false;           ///< y is not compared
  bool positions = false;         ///< pairs of positions in the order
  bool as_swept = false;          ///< the box that starts first is named first
  bool unsorted = false;          ///< pairs are in the order of the sweep
  bool touching_counted = false;  ///< instead of comparisons
  bool no_stop = false;           ///< all pairs are compared
  bool beyond_counted = false;    ///< also the box that ends a search
};

inline Swept sweep(const std::vector<Box>& boxes, const Ways& ways) {
  Swept swept{{}, 0};
  const std::vector<int> order = order_along_x(boxes, ways.order);
  const int n = static_cast<int>(order.size());
  for (int first = 0; first < n; ++first) {
    const int i = order[static_cast<std::size_t>(first)];
    for (int next = first + 1; next < n; ++next) {
      const int j = order[static_cast<std::size_t>(next)];
      const Box &a = at(boxes, i), &b = at(boxes, j);
      const bool apart = ways.ends_missed ? b.low.x() >= a.high.x() : b.low.x() > a.high.x();
      if (apart && ways.beyond_counted) ++swept.compared;
      if (apart && !ways.no_stop) break;
      ++swept.compared;
      const bool along_y =
          ways.y_missed ? a.low.y() < b.high.y() && b.low.y() < a.high.y() : meet(a, b, 1);
      const bool touch = !apart && meet(a, b, 0) && (ways.x_alone || along_y);
      if (touch) {
        std::array<int, 2> pair{i, j};
        if (ways.positions) pair = {first, next};
        if (!ways.as_swept && pair[0] > pair[1]) std::swap(pair[0], pair[1]);
        swept.touching.push_back(pair);
      }
      if (ways.next_alone || (ways.stops_early && !touch)) break;
    }
  }
  if (!ways.unsorted) std::sort(swept.touching.begin(), swept.touching.end());
  if (ways.touching_counted) swept.compared = static_cast<int>(swept.touching.size());
  return swept;
}

}  // namespace sweep_with_mistakes
