// tree_pairs.hpp: a tree whose boxes move, and what refitting costs.
#include <algorithm>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/tree_pairs.hpp>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "families.hpp"
#include "support/generators.hpp"

namespace {

using contact::Aabb;
using contact::BoxTree;
using contact::PairSearch;
using contact::Vector3;
using families::Boxes;
using generators::Random;

/// The pairs of all_pairs(), which reference_pairs_test.cpp compares with fractions.
template <class S>
std::vector<contact::BoxPair> listed_pairs(const std::vector<Aabb<S>>& boxes) {
  return contact::all_pairs<S>(boxes).pairs;
}

/// Each box takes the position of another.
template <class S>
void mix(Random& random, std::vector<Aabb<S>>& boxes) {
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const int other = random.integer(0, int(i));
    std::swap(boxes[i], boxes[static_cast<std::size_t>(other)]);
  }
}

/// Whether the box of each node is the smallest one of the items below it.
template <class S>
bool is_tight(const contact::BoxHierarchy<S>& tree, const std::vector<Aabb<S>>& boxes,
              std::size_t node, Aabb<S>& all) {
  const auto& self = tree.nodes[node];
  const auto first = static_cast<std::size_t>(self.first);
  bool tight = true;
  if (self.count == 0) {
    Aabb<S> other;
    tight = is_tight(tree, boxes, first, all);
    tight = is_tight(tree, boxes, first + 1, other) && tight;
    all = contact::enclosing_box(all, other);
  } else {
    all = boxes[static_cast<std::size_t>(tree.order[first])];
    for (std::size_t i = first; i < first + static_cast<std::size_t>(self.count); ++i)
      all = contact::enclosing_box(all, boxes[static_cast<std::size_t>(tree.order[i])]);
  }
  return tight && self.box.low == all.low && self.box.high == all.high;
}

}  // namespace

TEMPLATE_TEST_CASE("a refitted tree finds the pairs of all pairs, in tight boxes", "", float,
                   double) {
  using S = TestType;
  Random random(61);
  std::size_t found = 0;
  for (const Boxes family : families::all) {
    if (family == Boxes::huge) continue;
    for (const double most : {0.02, 1.0, 30.0}) {
      auto boxes = families::make<S>(random, family, random.integer(0, 60));
      BoxTree<S> tree(boxes);
      CHECK(tree.growth() == 1);
      for (int step = 0; step < 8; ++step) {
        for (Aabb<S>& box : boxes) {
          const Vector3<S> by = families::in_box<S>(random, most);
          box = {Vector3<S>(box.low + by), Vector3<S>(box.high + by)};
        }
        tree.refit(boxes);
        const PairSearch search = tree.pairs();
        INFO(families::name(family) << ", " << boxes.size() << " boxes, moves of " << most);
        REQUIRE(search.pairs == listed_pairs(boxes));
        REQUIRE(search.box_tests <= contact::all_pairs<S>(boxes).box_tests);
        found += search.pairs.size();
        Aabb<S> all;
        REQUIRE((boxes.empty() || is_tight(tree.hierarchy(), boxes, 0, all)));
      }
    }
  }
  CHECK(found > 700);
}

TEST_CASE("a tree says that it has become bad when its bodies have mixed, and not when all move") {
  Random random(62);
  auto boxes = families::make<double>(random, Boxes::scattered, 400);
  BoxTree<double> tree(boxes);
  const auto as_new = tree.pairs();
  for (Aabb<double>& box : boxes) {
    const Vector3<double> by(64, -64, 64);
    box = {Vector3<double>(box.low + by), Vector3<double>(box.high + by)};
  }
  tree.refit(boxes);
  CHECK_FALSE(tree.is_bad());
  CHECK(tree.growth() < 1.001);
  CHECK(tree.pairs().other_steps < as_new.other_steps * 11 / 10);
  mix(random, boxes);
  tree.refit(boxes);
  CHECK(tree.is_bad());
  const PairSearch mixed = tree.pairs();
  CHECK(mixed.pairs == listed_pairs(boxes));
  CHECK(mixed.other_steps > 2 * as_new.other_steps);
  tree = BoxTree<double>(boxes);
  CHECK(tree.growth() == 1);
  CHECK(tree.pairs().other_steps < mixed.other_steps / 2);
}

TEMPLATE_TEST_CASE("the size of everything does not make a tree bad, and does not hide a bad one",
                   "", float, double) {
  using S = TestType;
  Random random(65);
  auto boxes = families::make<S>(random, Boxes::scattered, 400);
  const auto scale = [&](S factor) {
    for (Aabb<S>& box : boxes) box = {Vector3<S>(factor * box.low), Vector3<S>(factor * box.high)};
  };
  BoxTree<S> tree(boxes);
  const auto as_new = tree.pairs();
  for (const S factor : {S(2), S(1024), S(0x1p-24)}) {
    scale(factor);
    tree.refit(boxes);
    INFO("scaled by " << factor);
    CHECK(tree.growth() == 1);
    CHECK(tree.pairs().other_steps == as_new.other_steps);
  }
  mix(random, boxes);
  scale(S(0x1p-10));
  tree.refit(boxes);
  CHECK(tree.is_bad());
  CHECK(tree.pairs().other_steps > 2 * as_new.other_steps);
}

TEST_CASE("points on a line: a tree says when it is bad, also with one beside the line") {
  Random random(66);
  for (const Vector3<double>& along :
       {Vector3<double>(1, 0, 0), Vector3<double>(0, 1, -1), Vector3<double>(1e-310, 0, 0),
        Vector3<double>(0, 1e306, 0)}) {
    for (const int beside : {0, 1}) {
      std::vector<Aabb<double>> points;
      for (int i = 0; i < 100; ++i) {
        const Vector3<double> at = along * i;
        points.push_back({at, at});
      }
      const Vector3<double> other = beside * along.cwiseAbs().sum() * Vector3<double>(0, 0, 1);
      points.push_back({other, other});
      INFO("steps of " << along.transpose() << ", beside it " << beside);
      BoxTree<double> tree(points);
      CHECK(tree.growth() == 1);
      mix(random, points);
      tree.refit(points);
      CHECK(tree.is_bad());
      const PairSearch mixed = tree.pairs();
      CHECK(mixed.other_steps > 4 * BoxTree<double>(points).pairs().other_steps);
    }
  }
}

TEST_CASE("a tree built of points at one position, or subnormal ones, says when it is bad") {
  Random random(67);
  constexpr std::size_t n = 100;
  const std::vector<Aabb<double>> at_origin(n);
  std::vector<Aabb<double>> points(n), later(n);
  for (std::size_t i = 0; i < n; ++i) {
    points[i].low.x() = points[i].high.x() = double(i) * 1e-310;
    later[i].low.x() = later[i].high.x() = double(i) * 1e5;
  }
  // The same arrangement, so the tree is as good as it was.
  BoxTree<double> tree(points), blind(at_origin);
  tree.refit(later);
  CHECK(std::abs(tree.growth() - 1) < 1e-9);
  mix(random, later);
  tree.refit(later);
  CHECK(tree.is_bad());
  CHECK(blind.growth() == 1);
  blind.refit(later);
  CHECK(blind.growth() == std::numeric_limits<double>::infinity());
  CHECK(blind.is_bad());
}

TEST_CASE("a query counts its comparisons, and finds what touches after refitting") {
  Random random(63);
  auto boxes = families::make<double>(random, Boxes::scattered, 300);
  BoxTree<double> tree(boxes);
  for (Aabb<double>& box : boxes) {
    const Vector3<double> by = families::in_box<double>(random, 0.5);
    box = {Vector3<double>(box.low + by), Vector3<double>(box.high + by)};
  }
  tree.refit(boxes);
  PairSearch counts;
  std::size_t touched = 0;
  for (const Aabb<double>& box : families::make<double>(random, Boxes::scattered, 300)) {
    std::vector<std::uint32_t> right;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      if (contact::boxes_touch(boxes[i], box)) right.push_back(i);
    }
    CHECK(tree.touching(box, &counts) == right);
    touched += right.size();
  }
  CHECK(counts.pairs.empty());
  CHECK(counts.box_tests >= touched);
  CHECK(counts.box_tests < 300 * 300 / 10);
  CHECK(counts.other_steps >= 300);
}

TEST_CASE("what is no box is compared with all, also when it becomes one") {
  Random random(64);
  auto boxes = families::make<double>(random, Boxes::scattered, 40);
  BoxTree<double> tree(boxes);
  const Aabb<double> before = boxes[11];
  boxes[11].high.x() = std::numeric_limits<double>::infinity();
  std::swap(boxes[20].low, boxes[20].high);
  tree.refit(boxes);
  CHECK(tree.pairs().pairs == contact::all_pairs<double>(boxes).pairs);
  CHECK(tree.hierarchy().order.size() == 38);
  CHECK(tree.touching(boxes[11]).size() ==
        std::size_t(std::count_if(boxes.begin(), boxes.end(), [&](const auto& box) {
          return contact::boxes_touch(box, boxes[11]);
        })));
  boxes[11] = before;
  tree.refit(boxes);
  CHECK(tree.pairs().pairs == contact::all_pairs<double>(boxes).pairs);
  CHECK(tree.hierarchy().order.size() == 39);
  CHECK_THROWS_AS(tree.refit(std::vector<Aabb<double>>(39)), std::invalid_argument);
}
