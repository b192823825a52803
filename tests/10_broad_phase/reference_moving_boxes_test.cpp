// moving_boxes.hpp: boxes over a step contain all of it, and fat boxes lose no pair.
#include <algorithm>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/moving_boxes.hpp>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

#include "families.hpp"
#include "reference.hpp"
#include "support/generators.hpp"

namespace {

using contact::Aabb;
using contact::FatBoxPairs;
using contact::PairSearch;
using contact::Vector3;
using families::Boxes;
using generators::Random;
using oracle::Rational;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// The pairs of all_pairs(), which reference_pairs_test.cpp compares with fractions.
template <class S>
std::vector<contact::BoxPair> compared_pairs(const std::vector<Aabb<S>>& boxes) {
  return contact::all_pairs<S>(boxes).pairs;
}

template <class S>
Aabb<S> moved(const Aabb<S>& box, const Vector3<S>& by) {
  return {Vector3<S>(box.low + by), Vector3<S>(box.high + by)};
}

/// Boxes of the family that do not overflow if they move a little.
bool can_move(Boxes family) { return family != Boxes::huge; }

}  // namespace

TEMPLATE_TEST_CASE("a box over a step contains the body at each of its times", "", float, double) {
  using S = TestType;
  Random random(41);
  for (const Boxes family : families::all) {
    if (!can_move(family)) continue;
    for (int round = 0; round < generators::tried(24); ++round) {
      const auto start = families::make<S>(random, family, 4);
      std::vector<Aabb<S>> end;
      for (const Aabb<S>& box : start) end.push_back(moved<S>(box, families::in_box<S>(random, 3)));
      const S margin = round % 2 == 0 ? S(0) : static_cast<S>(random.uniform(0, 2));
      const auto over = contact::boxes_over_step<S>(start, end, margin);
      for (std::size_t i = 0; i < start.size(); ++i) {
        for (int seventh = 0; seventh <= 7; ++seventh) {
          const Rational t = Rational(seventh) / 7;
          for (int k = 0; k < 3; ++k) {
            const auto at = [&](const Vector3<S>& from, const Vector3<S>& to) -> Rational {
              return oracle::exact(from(k)) * (1 - t) + oracle::exact(to(k)) * t;
            };
            REQUIRE(oracle::exact(over[i].low(k)) <=
                    at(start[i].low, end[i].low) - oracle::exact(margin));
            REQUIRE(oracle::exact(over[i].high(k)) >=
                    at(start[i].high, end[i].high) + oracle::exact(margin));
          }
        }
        // No larger than needed without a margin: a face is one of the ends'.
        if (margin > S(0)) continue;
        for (int k = 0; k < 3; ++k) {
          REQUIRE(over[i].low(k) == std::min(start[i].low(k), end[i].low(k)));
          REQUIRE(over[i].high(k) == std::max(start[i].high(k), end[i].high(k)));
        }
      }
    }
  }
}

TEST_CASE("a fast body meets a thin wall only over the step") {
  const Vector3<double> one(1, 1, 1);
  const std::vector<Aabb<double>> start{{-one, Vector3<double>::Zero()},
                                        {Vector3<double>(5, -9, -9), Vector3<double>(5, 9, 9)}};
  const std::vector<Aabb<double>> end{moved<double>(start[0], Vector3<double>(10, 0, 0)), start[1]};
  CHECK(contact::all_pairs<double>(start).pairs.empty());
  CHECK(contact::all_pairs<double>(end).pairs.empty());
  const auto over = contact::boxes_over_step<double>(start, end);
  CHECK(contact::all_pairs<double>(over).pairs.size() == 1);
}

TEST_CASE("boxes over a step refuse lists of different lengths, and wrong margins") {
  const std::vector<Aabb<double>> one(1), two(2);
  CHECK_THROWS_AS(contact::boxes_over_step<double>(one, two), std::invalid_argument);
  for (const double margin : {-1.0, not_a_number, infinity})
    CHECK_THROWS_AS(contact::boxes_over_step<double>(one, one, margin), std::invalid_argument);
  const double largest = std::numeric_limits<double>::max();
  const std::vector<Aabb<double>> far{{Vector3<double>::Zero(), Vector3<double>(largest, 0, 0)}};
  CHECK_THROWS_AS(contact::boxes_over_step<double>(far, far, 1e300), std::invalid_argument);
  CHECK(contact::boxes_over_step<double>({}, {}).empty());
  // What is no box would give one that touches less than it.
  const Aabb<double> box{Vector3<double>::Zero(), Vector3<double>::Ones()};
  for (const Vector3<double>& low :
       {Vector3<double>::Constant(not_a_number).eval(), Vector3<double>(0, not_a_number, 0),
        Vector3<double>(0, 2, 0), Vector3<double>(-infinity, 0, 0)}) {
    const std::vector<Aabb<double>> good{box}, bad{{low, box.high}};
    CHECK_THROWS_AS(contact::boxes_over_step<double>(good, bad), std::invalid_argument);
    CHECK_THROWS_AS(contact::boxes_over_step<double>(bad, good), std::invalid_argument);
  }
}

TEMPLATE_TEST_CASE("a fat box has its margin, rounded outwards, or ends at the largest number", "",
                   float, double) {
  using S = TestType;
  const S largest = std::numeric_limits<S>::max();
  Random random(42);
  for (const Boxes family : families::all) {
    for (const Aabb<S>& box : families::make<S>(random, family, generators::tried(64))) {
      for (const S margin : {S(0), S(0.1), std::numeric_limits<S>::denorm_min(), largest / 4}) {
        const Aabb<S> fat = contact::fat_box(box, margin);
        REQUIRE(contact::all_finite(fat.low));
        REQUIRE(contact::all_finite(fat.high));
        REQUIRE(contact::box_contains(fat, box));
        for (int k = 0; k < 3; ++k) {
          const Rational high = oracle::exact(box.high(k)) + oracle::exact(margin);
          const Rational low = oracle::exact(box.low(k)) - oracle::exact(margin);
          if (fat.high(k) != largest) REQUIRE(oracle::exact(fat.high(k)) >= high);
          if (fat.low(k) != -largest) REQUIRE(oracle::exact(fat.low(k)) <= low);
          // The next number inwards is too small.
          if (fat.high(k) != -largest)
            REQUIRE(oracle::exact(std::nextafter(fat.high(k), -largest)) < high);
          if (fat.low(k) != largest)
            REQUIRE(oracle::exact(std::nextafter(fat.low(k), largest)) > low);
        }
      }
    }
  }
}

TEMPLATE_TEST_CASE("fat boxes: the pairs are those of all pairs at each step", "", float, double) {
  using S = TestType;
  Random random(43);
  std::size_t some_renewed = 0, none_renewed = 0, found = 0;
  for (const Boxes family : families::all) {
    for (const double step : {0.01, 0.2, 2.0}) {
      auto boxes = families::make<S>(random, family, 50);
      FatBoxPairs<S> fat(S(0.25));
      for (int round = 0; round < 12; ++round) {
        const PairSearch search = fat.update(boxes);
        INFO(families::name(family) << ", steps of " << step << ", round " << round);
        const auto right = compared_pairs(boxes);
        REQUIRE(search.pairs == right);
        found += right.size();
        for (std::size_t i = 0; i < boxes.size(); ++i)
          REQUIRE(contact::box_contains(fat.fat_boxes()[i], boxes[i]));
        const auto fat_right =
            compared_pairs(std::vector<Aabb<S>>(fat.fat_boxes().begin(), fat.fat_boxes().end()));
        REQUIRE(std::equal(fat.fat_pairs().begin(), fat.fat_pairs().end(), fat_right.begin(),
                           fat_right.end()));
        if (fat.renewed() == 0) {
          ++none_renewed;
          REQUIRE(search.box_tests == fat_right.size());
          REQUIRE(search.other_steps == boxes.size());
        } else if (fat.renewed() < boxes.size()) {
          ++some_renewed;
        }
        if (!can_move(family)) continue;
        for (Aabb<S>& box : boxes) box = moved<S>(box, families::in_box<S>(random, step));
      }
    }
  }
  CHECK(found > 3000);
  CHECK(some_renewed > 60);
  CHECK(none_renewed > 30);
}

TEST_CASE("a body keeps its fat box as long as it is in it, its faces included") {
  std::vector<Aabb<double>> boxes{{Vector3<double>::Zero(), Vector3<double>::Ones()}};
  FatBoxPairs<double> fat(0.5);
  CHECK(fat.margin() == 0.5);
  fat.update(boxes);
  CHECK(fat.renewed() == 1);
  boxes[0] = moved<double>(boxes[0], Vector3<double>(0.5, 0, 0));
  fat.update(boxes);
  CHECK(fat.renewed() == 0);
  boxes[0].high.x() = std::nextafter(1.5, 2.0);
  fat.update(boxes);
  CHECK(fat.renewed() == 1);
}

TEST_CASE("fat boxes of a list with errors, and of one that has changed its length") {
  Random random(44);
  auto boxes = families::make<double>(random, Boxes::scattered, 30);
  FatBoxPairs<double> fat(0.25);
  fat.update(boxes);
  const Aabb<double> before = boxes[7];
  boxes[7].low.y() = not_a_number;
  std::swap(boxes[9].low, boxes[9].high);
  CHECK(fat.update(boxes).pairs == contact::all_pairs<double>(boxes).pairs);
  boxes[7] = before;
  CHECK(fat.update(boxes).pairs == contact::all_pairs<double>(boxes).pairs);
  std::swap(boxes[9].low, boxes[9].high);
  CHECK(fat.update(boxes).pairs == compared_pairs(boxes));
  boxes.pop_back();
  CHECK(fat.update(boxes).pairs == compared_pairs(boxes));
  boxes.clear();
  CHECK(fat.update(boxes).pairs.empty());
  for (const double margin : {-0.1, not_a_number, infinity})
    CHECK_THROWS_AS(FatBoxPairs<double>(margin), std::invalid_argument);
}
