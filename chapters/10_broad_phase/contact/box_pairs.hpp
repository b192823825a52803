/// @file
/// The result of every broad phase, and the simplest method: all pairs.
#pragma once

#include <cassert>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <contact/aabb.hpp>

namespace contact {

/// Two boxes of a list, by their indices.
struct BoxPair {
  std::uint32_t a = 0;  ///< the smaller index
  std::uint32_t b = 0;  ///< the larger index
  /// By a, then by b.
  friend auto operator<=>(const BoxPair&, const BoxPair&) = default;
};

/// The pairs that touch, and the work that it took to find them.
struct PairSearch {
  std::vector<BoxPair> pairs;     ///< each once, in increasing order: the same for every method
  std::uint64_t box_tests = 0;    ///< number of comparisons of two boxes of the list
  std::uint64_t other_steps = 0;  ///< other work; each method says what it counts
};

namespace detail {

/// The number of boxes. More than a BoxPair can index is an error of the program.
template <class Boxes>
std::uint32_t box_count(const Boxes& boxes) {
  assert(boxes.size() <= std::numeric_limits<std::uint32_t>::max());
  return static_cast<std::uint32_t>(boxes.size());
}

/// Compares boxes i and j, and records the pair if they touch.
template <Ring S>
void test_pair(std::span<const Aabb<S>> boxes, std::uint32_t i, std::uint32_t j,
               PairSearch& search) {
  ++search.box_tests;
  if (boxes_touch(boxes[i], boxes[j]))
    search.pairs.push_back(i < j ? BoxPair{i, j} : BoxPair{j, i});
}

}  // namespace detail

// [all-pairs]
/// The pairs of boxes that touch, by comparing each with each: exactly n (n − 1) / 2 tests.
///
/// For a few dozen boxes no method is faster. The other methods are tested against it.
/// @param boxes n of them, at most 2^32 − 1
template <Ring S>
PairSearch all_pairs(std::span<const Aabb<S>> boxes) {
  PairSearch search;
  const std::uint32_t n = detail::box_count(boxes);
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = i + 1; j < n; ++j) detail::test_pair(boxes, i, j, search);
  }
  return search;
}
// [/all-pairs]

}  // namespace contact
