// regions.hpp: subdivision by regions against all pairs, and where a body of two regions is.
#include <algorithm>
#include <array>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <contact/regions.hpp>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

#include "families.hpp"
#include "reference.hpp"
#include "support/generators.hpp"

namespace {

using contact::Aabb;
using contact::PairSearch;
using contact::RegionRange;
using contact::Regions;
using contact::Vector3;
using generators::Random;
using reference::right_pairs;

/// Borders at faces of the boxes and elsewhere: increasing, up to `most` on an axis.
template <class S>
Regions<S> drawn_regions(Random& random, const std::vector<Aabb<S>>& boxes, int most) {
  std::array<std::vector<S>, 3> borders;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<S>& of = borders[static_cast<std::size_t>(axis)];
    const int count = random.integer(0, most);
    for (int i = 0; i < count; ++i) {
      const int kind = random.integer(0, 2);
      const int which = random.integer(0, 1000);
      const double anywhere = random.uniform(-5, 5);
      if (kind == 2 || boxes.empty()) {
        of.push_back(static_cast<S>(anywhere));
      } else {
        const Aabb<S>& box = boxes[static_cast<std::size_t>(which) % boxes.size()];
        of.push_back(kind == 0 ? box.low(axis) : box.high(axis));
      }
    }
    std::sort(of.begin(), of.end());
    of.erase(std::unique(of.begin(), of.end()), of.end());
  }
  return Regions<S>(borders);
}

bool share(const RegionRange& a, const RegionRange& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (a.high[k] < b.low[k] || b.high[k] < a.low[k]) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("each number is in the one interval between whose borders it is") {
  const double largest = std::numeric_limits<double>::max();
  const std::vector<double> borders{-largest, -1, -0x1p-1074, 0, 0.1, 3, largest};
  const Regions<double> regions({borders, {}, {}});
  CHECK(regions.count() == borders.size() + 1);
  std::vector<double> numbers{-0.0, 0x1p-1074, 2, 5, -2};
  for (const double border : borders) {
    numbers.push_back(border);
    numbers.push_back(std::nextafter(border, largest));
    numbers.push_back(std::nextafter(border, -largest));
  }
  for (const double x : numbers) {
    const std::uint32_t i = regions.interval(x, 0);
    INFO(x << " in " << i);
    if (i > 0) CHECK(borders[i - 1] <= x);
    if (i < borders.size()) CHECK(x < borders[i]);
    CHECK(regions.interval(x, 1) == 0);
  }
}

TEMPLATE_TEST_CASE("regions: each pair that touches is found, by one region", "", float, double) {
  using S = TestType;
  Random random(21);
  std::uint64_t repeated = 0;
  for (const families::Boxes family : families::all) {
    for (int round = 0; round < generators::tried(24); ++round) {
      const auto boxes = families::make<S>(random, family, random.integer(0, 50));
      const std::span<const Aabb<S>> view(boxes);
      const Regions<S> regions = drawn_regions(random, boxes, 4);
      const PairSearch search = contact::region_pairs(view, regions);
      INFO(families::name(family) << ", " << boxes.size() << " boxes");
      REQUIRE(search.pairs == right_pairs(boxes));
      // Comparisons: the pairs with a common region, once each.
      std::uint64_t sharing = 0, entries = 0;
      std::uint64_t met = 0;
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        const RegionRange one = regions.of(boxes[i]);
        entries += one.regions();
        for (std::size_t j = i + 1; j < boxes.size(); ++j) {
          const RegionRange other = regions.of(boxes[j]);
          if (!share(one, other)) continue;
          ++sharing;
          RegionRange common;
          for (std::size_t k = 0; k < 3; ++k) {
            common.low[k] = std::max(one.low[k], other.low[k]);
            common.high[k] = std::min(one.high[k], other.high[k]);
          }
          met += common.regions();
        }
      }
      REQUIRE(search.box_tests == sharing);
      REQUIRE(search.other_steps == entries + met - sharing);
      repeated += met - sharing;
    }
  }
  CHECK(repeated > std::uint64_t(generators::tried(1000)));
}

TEST_CASE("a body on a border is in both regions, and its pair is reported once") {
  const Regions<double> regions({std::vector<double>{0}, {}, {}});
  const Vector3<double> one(1, 1, 1);
  // The first ends on the border, the second begins there, and the third reaches into both.
  const std::vector<Aabb<double>> boxes{
      {-one, Vector3<double>(0, 1, 1)}, {Vector3<double>::Zero(), one}, {-one / 2, one / 2}};
  const auto bodies = contact::bodies_in_regions<double>(boxes, regions);
  CHECK(bodies == std::vector<std::vector<std::uint32_t>>{{0, 2}, {0, 1, 2}});
  const PairSearch search = contact::region_pairs<double>(boxes, regions);
  CHECK(search.pairs == std::vector<contact::BoxPair>{{0, 1}, {0, 2}, {1, 2}});
  CHECK(search.box_tests == 3);
  CHECK(contact::reporting_region(regions, regions.of(boxes[0]), regions.of(boxes[2])) == 0);
  CHECK(contact::reporting_region(regions, regions.of(boxes[0]), regions.of(boxes[1])) == 1);
  // With one region for each body the pairs across the border are missed.
  CHECK(contact::pairs_of_one_region_each<double>(boxes, regions).pairs ==
        std::vector<contact::BoxPair>{{1, 2}});
}

TEST_CASE("one region for each body finds some of the pairs, and no other") {
  Random random(22);
  std::size_t missed = 0;
  for (const families::Boxes family : families::all) {
    const auto boxes = families::make<double>(random, family, generators::tried(160));
    const auto regions = drawn_regions(random, boxes, 3);
    const auto right = right_pairs(boxes);
    const auto found = contact::pairs_of_one_region_each<double>(boxes, regions).pairs;
    CHECK(std::includes(right.begin(), right.end(), found.begin(), found.end()));
    missed += right.size() - found.size();
  }
  CHECK(missed > std::size_t(generators::tried(80)));
}

TEST_CASE("equal regions divide the range of the boxes") {
  const Vector3<double> low(0, -4, 2), high(8, 4, 2);
  const std::vector<Aabb<double>> boxes{{low, low}, {high, high}};
  const auto regions = contact::equal_regions<double>(boxes, {4, 2, 5});
  CHECK(regions.borders()[0] == std::vector<double>{2, 4, 6});
  CHECK(regions.borders()[1] == std::vector<double>{0});
  CHECK(regions.borders()[2].empty());
  CHECK(regions.count() == 8);
  CHECK(contact::equal_regions<double>({}, {3, 3, 3}).count() == 1);
  const double largest = std::numeric_limits<double>::max();
  const std::vector<Aabb<double>> all{{Vector3<double>::Constant(-largest), high},
                                      {low, Vector3<double>::Constant(largest)}};
  CHECK(contact::equal_regions<double>(all, {4, 4, 4}).count() == 64);
}

TEST_CASE("regions refuse borders that are not increasing, not finite or too many") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  using Borders = std::vector<double>;
  CHECK_THROWS_AS(Regions<double>({Borders{1, 1}, {}, {}}), std::invalid_argument);
  CHECK_THROWS_AS(Regions<double>({Borders{}, {2, 1}, {}}), std::invalid_argument);
  CHECK_THROWS_AS(Regions<double>({Borders{}, {}, {nan}}), std::invalid_argument);
  CHECK_THROWS_AS(contact::equal_regions<double>({}, {0, 1, 1}), std::invalid_argument);
  Borders many;
  for (int i = 0; i < 128; ++i) many.push_back(i);
  CHECK_THROWS_AS(Regions<double>({many, many, many}), std::invalid_argument);
  many.pop_back();
  CHECK(Regions<double>({many, many, many}).count() == contact::max_regions);
}
