/// @file
/// Subdivision of space into regions with fixed borders: only bodies with a region in common can
/// touch. A body on a border belongs to several regions, and its pairs are reported once.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <contact/box_pairs.hpp>
#include <contact/exact_ray_triangle.hpp>
#include <contact/invalid_argument.hpp>

namespace contact {

/// The most regions of a subdivision.
inline constexpr std::uint64_t max_regions = std::uint64_t{1} << 21;

/// The regions that a box meets: on each axis all intervals from low to high.
struct RegionRange {
  std::array<std::uint32_t, 3> low{};   ///< the first interval on each axis
  std::array<std::uint32_t, 3> high{};  ///< the last interval on each axis; never less than low

  /// How many regions these are.
  std::uint64_t regions() const {
    std::uint64_t product = 1;
    for (std::size_t k = 0; k < 3; ++k) product *= std::uint64_t{high[k]} - low[k] + 1;
    return product;
  }
};

// [regions]
/// A subdivision of space: on each axis m borders make m + 1 half-open intervals (−∞, b₀),
/// [b₀, b₁), …, [b₍ₘ₋₁₎, ∞), and a region is a product of three intervals. Each point is in exactly
/// one region: nothing is rounded, because a coordinate is only compared with borders.
template <FloatOrDouble S>
class Regions {
 public:
  /// One region: all of space.
  Regions() = default;
  /// @param borders of each axis, m, finite and strictly increasing; an axis without any is one
  /// interval
  /// @throws std::invalid_argument if a border is not finite or not greater than the one before, or
  /// there are more than max_regions
  explicit Regions(std::array<std::vector<S>, 3> borders);

  /// The borders of each axis, m.
  const std::array<std::vector<S>, 3>& borders() const { return borders_; }
  /// How many regions there are.
  std::uint32_t count() const { return intervals(0) * intervals(1) * intervals(2); }
  // [region-of-box]
  /// The interval of an axis that contains x: the number of borders that are at most x. So it is
  /// monotonic: x ≤ y implies interval(x) ≤ interval(y). NaN is in the last one.
  std::uint32_t interval(S x, int axis) const {
    const std::vector<S>& b = borders_[static_cast<std::size_t>(axis)];
    return static_cast<std::uint32_t>(std::upper_bound(b.begin(), b.end(), x) - b.begin());
  }
  /// The regions that a box meets, its faces included: a box that ends on a border also meets the
  /// region behind it.
  /// @param box with low ≤ high
  RegionRange of(const Aabb<S>& box) const {
    RegionRange range;
    for (int k = 0; k < 3; ++k) {
      range.low[static_cast<std::size_t>(k)] = interval(box.low(k), k);
      range.high[static_cast<std::size_t>(k)] = interval(box.high(k), k);
    }
    return range;
  }
  // [/region-of-box]
  /// The number of a region, from 0 to count() − 1: x varies slowest.
  std::uint32_t number(std::uint32_t x, std::uint32_t y, std::uint32_t z) const {
    return (x * intervals(1) + y) * intervals(2) + z;
  }

 private:
  std::array<std::vector<S>, 3> borders_;

  std::uint32_t intervals(std::size_t axis) const {
    return static_cast<std::uint32_t>(borders_[axis].size()) + 1;
  }
};
// [/regions]

template <FloatOrDouble S>
Regions<S>::Regions(std::array<std::vector<S>, 3> borders) : borders_(std::move(borders)) {
  std::uint64_t product = 1;
  for (const std::vector<S>& axis : borders_) {
    for (std::size_t i = 0; i < axis.size(); ++i) {
      require_finite("borders", axis[i]);
      if (i > 0 && !(axis[i - 1] < axis[i])) {
        throw_invalid_argument("borders", number_text(axis[i]),
                               "must be greater than the border before it");
      }
    }
    // The product of two factors of at most 2^21 and 2^32 cannot overflow.
    if (axis.size() < max_regions) product *= axis.size() + 1;
    if (axis.size() >= max_regions || product > max_regions) {
      throw_invalid_argument("borders", std::to_string(axis.size()) + " borders on an axis",
                             "there may be at most 2^21 regions");
    }
  }
}

/// Regions of about equal size that divide the range of the boxes' coordinates. Their borders are
/// rounded; two that are equal are kept once, so there may be fewer intervals than asked for.
/// @param boxes n of them, with low ≤ high, finite; without any, or with one position only on an
/// axis, that axis is one interval
/// @param intervals on each axis, at least 1
/// @throws std::invalid_argument if a number of intervals is 0, or there are more than max_regions
template <FloatOrDouble S>
Regions<S> equal_regions(std::span<const Aabb<S>> boxes,
                         const std::array<std::uint32_t, 3>& intervals) {
  std::array<std::vector<S>, 3> borders;
  Aabb<S> all = boxes.empty() ? Aabb<S>{} : boxes.front();
  for (const Aabb<S>& box : boxes) all = enclosing_box(all, box);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    if (intervals[k] == 0 || intervals[k] > max_regions) {
      throw_invalid_argument("intervals", std::to_string(intervals[k]), "must be from 1 to 2^21");
    }
    for (std::uint32_t i = 1; i < intervals[k]; ++i) {
      // A convex combination cannot overflow.
      const S part = static_cast<S>(i) / static_cast<S>(intervals[k]);
      const S border = all.low[axis] * (S(1) - part) + all.high[axis] * part;
      if (std::isfinite(border) && (borders[k].empty() || borders[k].back() < border))
        borders[k].push_back(border);
    }
    if (!(all.low[axis] < all.high[axis])) borders[k].clear();
  }
  return Regions<S>(std::move(borders));
}

// [bodies-in-regions]
/// The bodies of each region, in increasing order: a body that meets several is in each of them.
/// @param boxes n of them, with low ≤ high
/// @return count() lists. All together have Σ of(box).regions() entries, which is the cost: n m for
/// n bodies that meet all of m regions
template <FloatOrDouble S>
std::vector<std::vector<std::uint32_t>> bodies_in_regions(std::span<const Aabb<S>> boxes,
                                                          const Regions<S>& regions) {
  std::vector<std::vector<std::uint32_t>> bodies(regions.count());
  for (std::uint32_t i = 0; i < detail::box_count(boxes); ++i) {
    if (!detail::is_box(boxes[i])) continue;
    const auto [low, high] = regions.of(boxes[i]);
    for (std::uint32_t x = low[0]; x <= high[0]; ++x) {
      for (std::uint32_t y = low[1]; y <= high[1]; ++y) {
        for (std::uint32_t z = low[2]; z <= high[2]; ++z)
          bodies[regions.number(x, y, z)].push_back(i);
      }
    }
  }
  return bodies;
}
// [/bodies-in-regions]

// [reporting-region]
/// The region that reports a pair of bodies: of those that both meet, the first on each axis.
///
/// The regions that both meet are a product of three ranges, from the larger low to the smaller
/// high. If it is not empty, its first element is one region, in which both bodies are entered; so
/// if the region reports the pair that is its own, the pair is reported exactly once.
/// @param a, b with a region in common
template <FloatOrDouble S>
std::uint32_t reporting_region(const Regions<S>& regions, const RegionRange& a,
                               const RegionRange& b) {
  return regions.number(std::max(a.low[0], b.low[0]), std::max(a.low[1], b.low[1]),
                        std::max(a.low[2], b.low[2]));
}
// [/reporting-region]

// [region-pairs]
/// The pairs of boxes that touch, found region by region: the same as those of all_pairs().
///
/// Boxes that touch have a point in common. It is in one region, and since interval() is monotonic,
/// both boxes are entered there. reporting_region() says which of their common regions tests them.
/// @param boxes n of them, at most 2^32 − 1; one that is no box (not finite, or low > high) is
/// compared with all
/// @return box_tests: the pairs with a region in common, once each; other_steps: entries of bodies
/// in regions, and pairs met in a region that does not report them
template <FloatOrDouble S>
PairSearch region_pairs(std::span<const Aabb<S>> boxes, const Regions<S>& regions) {
  PairSearch search;
  std::vector<RegionRange> ranges;
  ranges.reserve(boxes.size());
  for (const Aabb<S>& box : boxes) ranges.push_back(regions.of(box));
  const auto bodies = bodies_in_regions(boxes, regions);
  // [region-by-region]
  for (std::uint32_t region = 0; region < bodies.size(); ++region) {
    const std::vector<std::uint32_t>& here = bodies[region];
    search.other_steps += here.size();
    for (std::size_t k = 0; k < here.size(); ++k) {
      for (std::size_t l = k + 1; l < here.size(); ++l) {
        if (reporting_region(regions, ranges[here[k]], ranges[here[l]]) == region) {
          detail::test_pair(boxes, here[k], here[l], search);
        } else {
          ++search.other_steps;
        }
      }
    }
  }
  // [/region-by-region]
  detail::test_irregular(boxes, search);
  detail::sort_pairs(search.pairs);
  return search;
}
// [/region-pairs]

// [one-region-each]
/// The pairs found if each body is entered in one region only, that of its centre, as "which region
/// each object is in" suggests.
///
/// Limits: two bodies that touch are missed if their centres are in different regions. The other
/// pairs are right.
/// @param boxes n of them, with low ≤ high, finite
template <FloatOrDouble S>
PairSearch pairs_of_one_region_each(std::span<const Aabb<S>> boxes, const Regions<S>& regions) {
  std::vector<std::vector<std::uint32_t>> bodies(regions.count());
  for (std::uint32_t i = 0; i < detail::box_count(boxes); ++i) {
    const Vector3<S> centre = boxes[i].low / S(2) + boxes[i].high / S(2);
    bodies[regions.number(regions.interval(centre(0), 0), regions.interval(centre(1), 1),
                          regions.interval(centre(2), 2))]
        .push_back(i);
  }
  PairSearch search;
  for (const std::vector<std::uint32_t>& here : bodies) {
    for (std::size_t k = 0; k < here.size(); ++k) {
      for (std::size_t l = k + 1; l < here.size(); ++l)
        detail::test_pair(boxes, here[k], here[l], search);
    }
  }
  search.other_steps = boxes.size();
  detail::sort_pairs(search.pairs);
  return search;
}
// [/one-region-each]

}  // namespace contact
