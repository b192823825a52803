/// @file
/// Which boxes touch, by testing all pairs.
#pragma once

#include <algorithm>
#include <contact/box_pairs.hpp>
#include <vector>

#include "support/oracle.hpp"

namespace reference {

using contact::Aabb;
using contact::BoxPair;
using oracle::Rational;

/// Whether boxes touch, in fractions: the intersection of their ranges is not empty on any axis.
template <class S>
bool touch(const Aabb<S>& a, const Aabb<S>& b) {
  for (int k = 0; k < 3; ++k) {
    const Rational from = std::max(oracle::exact(a.low(k)), oracle::exact(b.low(k)));
    const Rational to = std::min(oracle::exact(a.high(k)), oracle::exact(b.high(k)));
    if (from > to) return false;
  }
  return true;
}

template <class S>
std::vector<BoxPair> right_pairs(const std::vector<Aabb<S>>& boxes) {
  std::vector<BoxPair> pairs;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    for (std::uint32_t j = i + 1; j < boxes.size(); ++j) {
      if (touch(boxes[i], boxes[j])) pairs.push_back({i, j});
    }
  }
  return pairs;
}

/// The number of pairs that overlap on one axis, by testing all.
template <class S>
std::uint64_t overlaps(const std::vector<Aabb<S>>& boxes, int axis) {
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = i + 1; j < boxes.size(); ++j) {
      if (boxes[i].low(axis) <= boxes[j].high(axis) && boxes[j].low(axis) <= boxes[i].high(axis))
        ++count;
    }
  }
  return count;
}

}  // namespace reference
