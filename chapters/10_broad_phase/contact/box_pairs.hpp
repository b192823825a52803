/// @file
/// The result of every broad phase, and the simplest method: all pairs.
#pragma once

#include <algorithm>
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

/// The same as boxes_touch() without branches: where the result is hard to predict, a mispredicted
/// branch costs more than six comparisons.
template <Ring S>
bool overlap(const Aabb<S>& a, const Aabb<S>& b) {
  int apart = 0;
  for (int k = 0; k < 3; ++k) apart |= int(a.high(k) < b.low(k)) | int(b.high(k) < a.low(k));
  return apart == 0;
}

/// Compares boxes i and j, and records the pair if they touch.
template <Ring S>
void test_pair(std::span<const Aabb<S>> boxes, std::uint32_t i, std::uint32_t j,
               PairSearch& search) {
  ++search.box_tests;
  if (boxes_touch(boxes[i], boxes[j]))
    search.pairs.push_back(i < j ? BoxPair{i, j} : BoxPair{j, i});
}

/// Sorts pairs by a, then by b: as one number, which is faster to compare than two.
inline void sort_pairs(std::vector<BoxPair>& pairs) {
  const auto number = [](const BoxPair& pair) { return (std::uint64_t{pair.a} << 32) | pair.b; };
  std::sort(pairs.begin(), pairs.end(),
            [&](const BoxPair& x, const BoxPair& y) { return number(x) < number(y); });
}

/// Whether the box is one: finite, with low ≤ high in each coordinate. Only then do orders, cells
/// and regions say something about it.
template <Ring S>
bool is_box(const Aabb<S>& box) {
  for (int k = 0; k < 3; ++k) {
    if (!is_finite(S(box.low(k))) || !is_finite(S(box.high(k))) || box.high(k) < box.low(k))
      return false;
  }
  return true;
}

/// Compares some of the boxes with every other one. Two of them are compared once: when the first
/// is processed.
/// @param some their indices, in increasing order
template <Ring S>
void test_with_all(std::span<const Aabb<S>> boxes, std::span<const std::uint32_t> some,
                   PairSearch& search) {
  const std::uint32_t n = box_count(boxes);
  std::size_t skipped = 0;
  for (std::size_t k = 0; k < some.size(); ++k, skipped = 0) {
    for (std::uint32_t j = 0; j < n; ++j) {
      if (skipped <= k && j == some[skipped]) {
        ++skipped;
      } else {
        test_pair(boxes, some[k], j, search);
      }
    }
  }
}

/// Compares each that is no box with all, as all_pairs() does: so every method has its pairs, also
/// for a list with errors.
template <Ring S>
void test_irregular(std::span<const Aabb<S>> boxes, PairSearch& search) {
  std::vector<std::uint32_t> irregular;
  for (std::uint32_t i = 0; i < box_count(boxes); ++i) {
    if (!is_box(boxes[i])) irregular.push_back(i);
  }
  test_with_all<S>(boxes, irregular, search);
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
