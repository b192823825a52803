// The sample of a grid's cells against the counts of the grid, and what the cost model chooses.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/broad_phase_cost.hpp>
#include <limits>
#include <span>
#include <vector>

#include "families.hpp"
#include "reference.hpp"
#include "support/generators.hpp"

using contact::Aabb;
using contact::BroadPhase;
using contact::CellSample;
using contact::PairSearch;
using contact::Vector3;
using families::Boxes;
using generators::Random;

TEMPLATE_TEST_CASE("a sample of up to 32 boxes is the count of the grid", "", float, double) {
  using S = TestType;
  Random random(21);
  int judged = 0;
  for (const Boxes family : families::all) {
    for (int round = 0; round < generators::tried(24); ++round) {
      const auto boxes = families::make<S>(random, family, random.integer(0, 32));
      const std::span<const Aabb<S>> view(boxes);
      const auto grid = contact::grid_for(view);
      const CellSample sample = contact::sample_cells(view, grid);
      if (sample.many_cells > 0) continue;
      const PairSearch search = contact::grid_pairs(view, grid);
      INFO(families::name(family) << ", " << boxes.size() << " boxes");
      CHECK(sample.in_cells == double(search.box_tests));
      CHECK(sample.entries + sample.repeated == double(search.other_steps));
      CHECK(sample.touching == double(search.pairs.size()));
      ++judged;
    }
  }
  CHECK(judged > generators::tried(100));
}

TEST_CASE("one huge box among hundreds counts with exactly its pairs") {
  constexpr int n = 400;
  for (const int at : {0, 12, 200, 399}) {
    std::vector<Aabb<double>> boxes;
    for (int i = 0; i < n; ++i)
      boxes.push_back({Vector3<double>(3.0 * i, 0, 0), Vector3<double>(3.0 * i + 1, 1, 1)});
    boxes[static_cast<std::size_t>(at)] = {Vector3<double>::Constant(-1),
                                           Vector3<double>::Constant(1201)};
    const std::span<const Aabb<double>> view(boxes);
    const CellSample sample = contact::sample_cells(view, contact::grid_for(view));
    CHECK(sample.many_cells == 1);
    CHECK(sample.touching == n - 1);
  }
}

TEST_CASE("boxes that are none do not stop the sample") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Aabb<double>> boxes{{{0, 0, 0}, {1, 1, 1}},
                                        {{nan, 0, 0}, {1, 1, 1}},
                                        {{3, 3, 3}, {2, 2, 2}},
                                        {{5, 5, 5}, {6, 6, 6}}};
  const std::span<const Aabb<double>> view(boxes);
  const CellSample sample = contact::sample_cells(view, contact::grid_for(view));
  CHECK(sample.many_cells == 2);
  CHECK(sample.in_cells <= 1);
  CHECK(std::isfinite(sample.touching));
}

TEST_CASE("the model chooses all pairs for few boxes, and where all touch") {
  for (const int n : {2, 8, 16, 200, 1000}) {
    std::vector<Aabb<double>> boxes;
    for (int i = 0; i < n; ++i)
      boxes.push_back({Vector3<double>::Constant(-1.0 - i), Vector3<double>::Constant(1.0 + i)});
    INFO(n << " boxes");
    CHECK(contact::broad_phase_cost<double>(boxes).cheapest() == BroadPhase::all_pairs);
  }
}

TEST_CASE("the model chooses the grid for many equal boxes far apart") {
  Random random(22);
  for (const int n : {1000, 4000}) {
    std::vector<Aabb<double>> boxes;
    for (int i = 0; i < n; ++i) {
      const auto low = families::in_box<double>(random, 5 * std::cbrt(double(n)));
      boxes.push_back({low, Vector3<double>(low + Vector3<double>::Ones())});
    }
    INFO(n << " boxes");
    CHECK(contact::broad_phase_cost<double>(boxes).cheapest() == BroadPhase::grid);
  }
}

TEST_CASE("the model leaves the grid where one box far away makes its cells too wide") {
  Random random(23);
  constexpr int n = 2000;
  std::vector<Aabb<double>> boxes;
  for (int i = 0; i < n; ++i) {
    const auto low = families::in_box<double>(random, std::cbrt(double(n)));
    boxes.push_back({low, Vector3<double>(low + Vector3<double>::Ones())});
  }
  CHECK(contact::broad_phase_cost<double>(boxes).cheapest() == BroadPhase::grid);
  boxes[77] = {Vector3<double>::Constant(1e6), Vector3<double>::Constant(1e6 + 1)};
  const auto cost = contact::broad_phase_cost<double>(boxes);
  CHECK(cost.grid > cost.tree);
  CHECK(cost.cheapest() == BroadPhase::tree);
}
