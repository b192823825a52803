// sweep_and_prune.hpp: kept pairs against all pairs, and the work of a step against counts.
#include <algorithm>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <contact/sweep_and_prune.hpp>
#include <limits>
#include <tuple>
#include <vector>

#include "families.hpp"
#include "support/generators.hpp"

namespace {

using contact::Aabb;
using contact::PairSearch;
using contact::SweepAndPrune;
using contact::Vector3;
using families::Boxes;
using generators::Random;

/// The pairs of all_pairs(), which reference_pairs_test.cpp compares with fractions.
template <class S>
std::vector<contact::BoxPair> checked_pairs(const std::vector<Aabb<S>>& boxes) {
  return contact::all_pairs<S>(boxes).pairs;
}

/// Moves each of the boxes by up to so much on each axis.
template <class S>
void move_all(Random& random, std::vector<Aabb<S>>& boxes, double most) {
  for (Aabb<S>& box : boxes) {
    const Vector3<S> by = families::in_box<S>(random, most);
    box = {Vector3<S>(box.low + by), Vector3<S>(box.high + by)};
  }
}

/// The order of the ends on an axis: number, beginnings first, then the list's order.
template <class S>
std::vector<std::tuple<S, int, std::size_t>> ends_of(const std::vector<Aabb<S>>& boxes, int axis) {
  std::vector<std::tuple<S, int, std::size_t>> ends;
  for (std::size_t i = 0; i < boxes.size(); ++i) ends.emplace_back(boxes[i].low(axis), 0, i);
  for (std::size_t i = 0; i < boxes.size(); ++i) ends.emplace_back(boxes[i].high(axis), 1, i);
  return ends;
}

}  // namespace

TEMPLATE_TEST_CASE("sweep and prune keeps the pairs of all pairs", "", float, double) {
  using S = TestType;
  Random random(51);
  int kept = 0;
  std::size_t found = 0;
  for (const Boxes family : families::all) {
    for (const double most : {0.0, 0.05, 1.0}) {
      auto boxes = families::make<S>(random, family, 50);
      SweepAndPrune<S> sweep;
      for (int step = 0; step < 12; ++step) {
        INFO(families::name(family) << ", moves of " << most << ", step " << step);
        const PairSearch search = sweep.update(boxes);
        REQUIRE(search.pairs == checked_pairs(boxes));
        found += search.pairs.size();
        if (step == 0) REQUIRE(sweep.resorted());
        if (!sweep.resorted()) ++kept;
        if (family != Boxes::huge) move_all(random, boxes, most);
      }
    }
  }
  CHECK(kept > 300);
  CHECK(found > 3000);
}

TEST_CASE("a step of sweep and prune compares what it says, and counts exchanges") {
  Random random(52);
  std::uint64_t all_exchanged = 0;
  for (const Boxes family : families::all) {
    if (family == Boxes::huge) continue;
    auto boxes = families::make<double>(random, family, 40);
    SweepAndPrune<double> sweep;
    sweep.update(boxes);
    for (int step = 0; step < 6; ++step) {
      const auto before = boxes;
      const std::size_t pairs_before = checked_pairs(boxes).size();
      move_all(random, boxes, 0.1);
      const PairSearch search = sweep.update(boxes);
      if (sweep.resorted()) continue;
      std::uint64_t exchanged = 0, met = 0;
      for (int axis = 0; axis < 3; ++axis) {
        const auto old_ends = ends_of(before, axis);
        const auto new_ends = ends_of(boxes, axis);
        for (std::size_t i = 0; i < old_ends.size(); ++i) {
          for (std::size_t j = 0; j < old_ends.size(); ++j) {
            if (!(old_ends[i] < old_ends[j]) || new_ends[i] < new_ends[j]) continue;
            ++exchanged;
            if (i >= boxes.size() && j < boxes.size()) ++met;
          }
        }
      }
      INFO(families::name(family) << ", step " << step);
      CHECK(search.other_steps == exchanged);
      CHECK(search.box_tests == pairs_before + met);
      all_exchanged += exchanged;
    }
  }
  CHECK(all_exchanged > 700);
}

TEST_CASE("boxes that come to touch exactly are met, and those that part by an ulp are dropped") {
  const auto at = [](double x) {
    return Aabb<double>{Vector3<double>(x, 0, 0), Vector3<double>(x + 1, 1, 1)};
  };
  std::vector<Aabb<double>> boxes{at(0), at(2)};
  SweepAndPrune<double> sweep;
  CHECK(sweep.update(boxes).pairs.empty());
  boxes[1] = at(1);
  CHECK(sweep.update(boxes).pairs.size() == 1);
  CHECK_FALSE(sweep.resorted());
  boxes[1].low.x() = std::nextafter(1.0, 2.0);
  CHECK(sweep.update(boxes).pairs.empty());
  // From the other side, where the index of the box that begins is the smaller one.
  boxes = {at(2), at(0)};
  CHECK(sweep.update(boxes).pairs.empty());
  boxes[0] = at(1);
  CHECK(sweep.update(boxes).pairs.size() == 1);
  CHECK_FALSE(sweep.resorted());
}

TEST_CASE("sweep and prune starts from scratch when a list does not continue the last") {
  Random random(53);
  auto boxes = families::make<double>(random, Boxes::scattered, 400);
  SweepAndPrune<double> sweep;
  sweep.update(boxes);
  CHECK(sweep.update(boxes).other_steps == 0);
  CHECK_FALSE(sweep.resorted());
  std::reverse(boxes.begin(), boxes.end());
  CHECK(sweep.update(boxes).pairs == checked_pairs(boxes));
  CHECK(sweep.resorted());
  boxes.pop_back();
  CHECK(sweep.update(boxes).pairs == checked_pairs(boxes));
  CHECK(sweep.resorted());
  boxes[3].low.z() = std::numeric_limits<double>::quiet_NaN();
  CHECK(sweep.update(boxes).pairs == contact::all_pairs<double>(boxes).pairs);
  CHECK(sweep.resorted());
  boxes[3] = boxes[4];
  CHECK(sweep.update(boxes).pairs == checked_pairs(boxes));
  CHECK(sweep.resorted());
  boxes[3] = boxes[5];
  CHECK(sweep.update(boxes).pairs == checked_pairs(boxes));
  CHECK_FALSE(sweep.resorted());
  CHECK(sweep.update({}).pairs.empty());
}

TEST_CASE("sweep and prune keeps no pair of a list with errors") {
  const Aabb<double> box{Vector3<double>::Zero(), Vector3<double>::Ones()};
  Aabb<double> no_box = box;
  no_box.low.x() = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Aabb<double>> boxes{no_box, box};
  SweepAndPrune<double> sweep;
  CHECK(sweep.update(boxes).pairs.size() == 1);
  // The pair must not be looked up in a list that does not have its boxes.
  const PairSearch none = sweep.update({});
  CHECK(none.pairs.empty());
  CHECK(none.box_tests == 0);
}
