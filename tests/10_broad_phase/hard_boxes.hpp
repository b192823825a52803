/// @file
/// Reads lists of boxes of the hard cases, and broad phases as they are often written.
#pragma once

#include <algorithm>
#include <cmath>
#include <contact/box_pairs.hpp>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "support/hard_cases.hpp"

namespace hard_boxes {

using contact::BoxPair;
using hard_cases::Case;
using hard_cases::Json;
using oracle::Rational;
using Box = contact::Aabb<double>;
using Boxes = std::vector<Box>;
using Pairs = std::vector<BoxPair>;
using V = contact::Vector3<double>;

/// Six numbers for each box: low, then high.
inline Boxes stored_boxes(const Case& c, const char* field = "boxes") {
  const std::vector<double> n = c.numbers(field);
  Boxes boxes;
  for (std::size_t k = 0; k + 6 <= n.size(); k += 6)
    boxes.push_back({V(n[k], n[k + 1], n[k + 2]), V(n[k + 3], n[k + 4], n[k + 5])});
  return boxes;
}
/// The boxes for a method. A corpus holds finite numbers only: in the family "infinite", ± the
/// largest double stands for ±∞, which changes no comparison.
inline Boxes read_boxes(const Case& c, const char* field = "boxes") {
  Boxes boxes = stored_boxes(c, field);
  if (c.family() != "infinite") return boxes;
  const auto widen = [](double x) {
    return std::abs(x) == std::numeric_limits<double>::max()
               ? std::copysign(std::numeric_limits<double>::infinity(), x)
               : x;
  };
  for (Box& box : boxes) {
    box.low = box.low.unaryExpr(widen);
    box.high = box.high.unaryExpr(widen);
  }
  return boxes;
}

inline Json as_json(const Pairs& pairs) {
  Json list = Json::array();
  for (const BoxPair& pair : pairs) list.push_back(Json::array({pair.a, pair.b}));
  return list;
}

/// The pairs of which `touch` says so, in order.
template <class Touch>
Pairs pairs_by(const Boxes& boxes, Touch touch) {
  Pairs pairs;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    for (std::uint32_t j = i + 1; j < boxes.size(); ++j) {
      if (touch(boxes[i], boxes[j])) pairs.push_back({i, j});
    }
  }
  return pairs;
}

/// Whether boxes touch, in fractions.
inline bool touch_exactly(const Box& a, const Box& b) {
  for (int k = 0; k < 3; ++k) {
    if (std::max(oracle::exact(a.low(k)), oracle::exact(b.low(k))) >
        std::min(oracle::exact(a.high(k)), oracle::exact(b.high(k))))
      return false;
  }
  return true;
}

/// A double as x86 converts it to a 32-bit integer: out of range, it is the least one.
inline std::int64_t to_int32(double x) {
  if (!(x > -2147483649.0) || !(x < 2147483648.0)) return std::numeric_limits<std::int32_t>::min();
  return static_cast<std::int64_t>(x);
}

/// The pairs that share a cell, by its number on each axis, and touch.
template <class Cell>
Pairs pairs_in_cells(const Boxes& boxes, Cell first, Cell last) {
  return pairs_by(boxes, [&](const Box& a, const Box& b) {
    for (int k = 0; k < 3; ++k) {
      if (std::max(first(a.low(k)), first(b.low(k))) > std::min(last(a.high(k)), last(b.high(k))))
        return false;
    }
    return contact::boxes_touch(a, b);
  });
}

/// Cells of 1 m from −1 to 1 around the middle's, with conversion to int in place of floor.
inline Pairs around_truncated_middle(const Boxes& boxes) {
  const auto cell = [](double x) { return to_int32(x); };
  return pairs_by(boxes, [&](const Box& a, const Box& b) {
    for (int k = 0; k < 3; ++k) {
      const double x = a.low(k) / 2 + a.high(k) / 2;
      // In double: huge coordinates have cells beyond any integer.
      const double other = std::floor(b.low(k) / 2 + b.high(k) / 2);
      if (std::abs(static_cast<double>(cell(x)) - other) > 1) return false;
    }
    return contact::boxes_touch(a, b);
  });
}

/// Cells of 1 m for the range [low, high): a face on a border does not reach the next cell.
inline Pairs half_open_ranges(const Boxes& boxes) {
  const std::function<double(double)> first = [](double x) { return std::floor(x); };
  const std::function<double(double)> last = [](double x) { return std::ceil(x) - 1; };
  return pairs_in_cells(boxes, first, last);
}

/// Cells of 1 m, numbered by 32-bit integers.
inline Pairs cells_of_32_bits(const Boxes& boxes) {
  const std::function<std::int64_t(double)> cell = [](double x) { return to_int32(std::floor(x)); };
  return pairs_in_cells(boxes, cell, cell);
}

/// A pair is reported in each cell of 1 m that both meet.
inline Pairs reported_in_each_cell(const Boxes& boxes) {
  Pairs pairs;
  for (const BoxPair& pair : pairs_by(boxes, touch_exactly)) {
    double cells = 1;
    for (int k = 0; k < 3; ++k) {
      const Box &a = boxes[pair.a], &b = boxes[pair.b];
      cells *=
          std::floor(std::min(a.high(k), b.high(k))) - std::floor(std::max(a.low(k), b.low(k))) + 1;
    }
    // Two say as much as many.
    for (double i = 0; i < std::min(cells, 2.0); ++i) pairs.push_back(pair);
  }
  return pairs;
}

/// A sweep over the starts along x that ends at the first box that does not touch on all axes.
inline Pairs stop_at_first_miss(const Boxes& boxes) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return boxes[i].low.x() < boxes[j].low.x();
  });
  Pairs pairs;
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      if (!contact::boxes_touch(boxes[order[i]], boxes[order[j]])) break;
      pairs.push_back({std::min(order[i], order[j]), std::max(order[i], order[j])});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// A sweep over the middles along x that ends at the first box that starts beyond the end.
inline Pairs sorted_by_middles(const Boxes& boxes) {
  std::vector<std::uint32_t> order;
  const auto middle = [&](std::uint32_t i) { return boxes[i].low.x() / 2 + boxes[i].high.x() / 2; };
  for (std::uint32_t i = 0; i < boxes.size(); ++i) order.push_back(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t i, std::uint32_t j) { return middle(i) < middle(j); });
  Pairs pairs;
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      if (boxes[order[j]].low.x() > boxes[order[i]].high.x()) break;
      if (contact::boxes_touch(boxes[order[i]], boxes[order[j]]))
        pairs.push_back({std::min(order[i], order[j]), std::max(order[i], order[j])});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// Boxes that are at most 1e-6 m apart.
inline Pairs within_a_margin(const Boxes& boxes) {
  return pairs_by(boxes, [](const Box& a, const Box& b) {
    for (int k = 0; k < 3; ++k) {
      if (a.low(k) > b.high(k) + 1e-6 || b.low(k) > a.high(k) + 1e-6) return false;
    }
    return true;
  });
}

/// Boxes whose intersection has a volume.
inline Pairs with_common_volume(const Boxes& boxes) {
  return pairs_by(boxes, [](const Box& a, const Box& b) {
    double volume = 1;
    for (int k = 0; k < 3; ++k)
      volume *= std::max(0.0, std::min(a.high(k), b.high(k)) - std::max(a.low(k), b.low(k)));
    return volume > 0;
  });
}

}  // namespace hard_boxes
