// broad_phase_cost.hpp: expected costs against counts.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/broad_phase_cost.hpp>
#include <span>
#include <vector>

#include "families.hpp"
#include "reference.hpp"
#include "support/generators.hpp"

using contact::Aabb;
using contact::PairSearch;
using contact::Vector3;
using families::Boxes;
using generators::Random;
using reference::overlaps;
using reference::right_pairs;

TEST_CASE("exact costs equal the counted comparisons") {
  Random random(6);
  for (const Boxes family : families::all) {
    for (const int n : {0, 1, 2, 3, 10, 75, 200}) {
      const auto boxes = families::make<double>(random, family, n);
      const std::span<const Aabb<double>> view(boxes);
      const auto count = static_cast<std::uint64_t>(n);
      INFO(families::name(family) << ", " << n << " boxes");
      CHECK(contact::pair_count(count) == (n > 0 ? count * (count - 1) / 2 : 0));
      CHECK(contact::all_pairs(view).box_tests == contact::pair_count(count));
      std::uint64_t fewest = contact::pair_count(count);
      for (int axis = 0; axis < 3; ++axis) {
        const std::uint64_t right = overlaps(boxes, axis);
        fewest = std::min(fewest, right);
        CHECK(contact::overlaps_on_axis(view, axis) == right);
        CHECK(contact::sweep_pairs(view, axis).box_tests == right);
      }
      CHECK(contact::sweep_pairs(view).box_tests == fewest);
      CHECK(contact::overlaps_on_axis(view, contact::best_sweep_axis(view)) == fewest);
      // No method compares a pair twice, and each compares every pair that touches.
      const auto pairs = contact::all_pairs(view).pairs.size();
      for (const PairSearch& search : {contact::grid_pairs(view), contact::tree_pairs(view)}) {
        CHECK(search.box_tests >= pairs);
        CHECK(search.box_tests <= contact::pair_count(count));
      }
    }
  }
  CHECK(contact::pair_count(std::uint64_t{1} << 32) == 0x7fffffff80000000u);
}

TEST_CASE("a grid never takes more comparisons than its bound") {
  Random random(7);
  int useful = 0;
  for (const Boxes family : families::all) {
    // If coordinates overflow or are far outside the grid, the bound is not claimed.
    if (family == Boxes::huge || family == Boxes::tiny) continue;
    for (int round = 0; round < generators::tried(24); ++round) {
      const auto boxes = families::make<double>(random, family, random.integer(2, 400));
      const std::span<const Aabb<double>> view(boxes);
      const auto grid = contact::grid_for(view);
      const std::uint64_t bound = contact::max_grid_tests(view, grid);
      INFO(families::name(family) << ", " << boxes.size() << " boxes");
      CHECK(contact::grid_pairs(view, grid).box_tests <= bound);
      if (2 * bound < contact::pair_count(boxes.size())) ++useful;
    }
  }
  CHECK(useful > generators::tried(24));
}

TEST_CASE("expected comparisons are the mean of many counts") {
  // Extents are fixed, lower ends uniformly distributed in [0, L): the mean of m counts is within
  // six standard errors of the expectation; the variance of the counts is measured as well.
  Random random(8);
  const int n = 40;
  const int rounds = 4000;
  for (const double largest : {0.05, 0.4, 1.0}) {
    std::vector<Vector3<double>> extents;
    contact::BoxProfile profile;
    profile.count = n;
    profile.spread = Vector3<double>(8, 8, 8);
    for (int i = 0; i < n; ++i) {
      // Equal sizes on axis 0; different ones on axis 1; on axis 2 some exceed the spread.
      const double y = random.uniform(0, 8 * largest);
      const double z = random.uniform(0, 20 * largest);
      extents.push_back({8 * largest / 2, y, z});
      profile.mean_extent += extents.back() / n;
      profile.mean_square_extent += extents.back().cwiseProduct(extents.back()) / n;
      profile.largest_extent = profile.largest_extent.cwiseMax(extents.back());
    }
    Vector3<double> sum = Vector3<double>::Zero();
    Vector3<double> squares = Vector3<double>::Zero();
    for (int round = 0; round < rounds; ++round) {
      std::vector<Aabb<double>> boxes;
      for (const auto& extent : extents) {
        const double x = random.uniform(0, 8);
        const double y = random.uniform(0, 8);
        const double z = random.uniform(0, 8);
        const Vector3<double> low(x, y, z);
        boxes.push_back({low, low + extent});
      }
      for (int axis = 0; axis < 3; ++axis) {
        const auto tests = double(contact::overlaps_on_axis<double>(boxes, axis));
        sum(axis) += tests;
        squares(axis) += tests * tests;
      }
    }
    for (int axis = 0; axis < 3; ++axis) {
      const double mean = sum(axis) / rounds;
      const double variance = squares(axis) / rounds - mean * mean;
      const double room = 6 * std::sqrt(variance / rounds) + 1e-9 * mean;
      const double expected = contact::expected_sweep_tests(profile, axis);
      INFO("largest extent " << largest << ", axis " << axis << ", mean " << mean << ", expected "
                             << expected);
      if (profile.largest_extent(axis) <= 8) {
        CHECK(std::abs(mean - expected) <= room);
      } else {
        CHECK(mean <= expected + room);
      }
    }
  }
}

TEST_CASE("expected touching pairs and grid comparisons of boxes of one size") {
  Random random(9);
  const int n = 60;
  const int rounds = 3000;
  const Vector3<double> extent(1, 2, 0.5);
  contact::BoxProfile profile;
  profile.count = n;
  profile.spread = Vector3<double>(8, 6, 4);
  profile.mean_extent = extent;
  profile.mean_square_extent = extent.cwiseProduct(extent);
  profile.largest_extent = extent;
  double sum = 0;
  double squares = 0;
  double grid_sum = 0;
  double grid_squares = 0;
  for (int round = 0; round < rounds; ++round) {
    std::vector<Aabb<double>> boxes;
    for (int i = 0; i < n; ++i) {
      const double x = random.uniform(0, 8);
      const double y = random.uniform(0, 6);
      const double z = random.uniform(0, 4);
      const Vector3<double> low(x, y, z);
      boxes.push_back({low, low + extent});
    }
    const contact::PairGrid<double> grid{Vector3<double>::Zero(), 2};
    const PairSearch search = contact::grid_pairs<double>(boxes, grid);
    const auto pairs = double(search.pairs.size());
    const auto tests = double(search.box_tests);
    sum += pairs;
    squares += pairs * pairs;
    grid_sum += tests;
    grid_squares += tests * tests;
  }
  const auto room = [&](double total, double total_of_squares) {
    const double mean = total / rounds;
    return 6 * std::sqrt((total_of_squares / rounds - mean * mean) / rounds);
  };
  const double expected = contact::expected_touching_pairs(profile);
  CHECK(std::abs(sum / rounds - expected) <= room(sum, squares));
  const double bound = contact::expected_grid_tests(profile, 2);
  CHECK(grid_sum / rounds <= bound + room(grid_sum, grid_squares));
  CHECK(grid_sum / rounds >= bound / 4);
}

TEST_CASE("a sample of few boxes is exact, and of many the estimate is close to the count") {
  Random random(13);
  for (const Boxes family : families::all) {
    const auto few = families::make<double>(random, family, 32);
    CHECK(contact::sampled_pairs<double>(few, 0) == double(right_pairs(few).size()));
  }
  CHECK(contact::sampled_pairs<double>({}, 1) == 0);
  // Each sampled box touches between 0 and n − 1 others; in clusters of equal size the mean of 32
  // is within a half of the mean of all.
  const auto many = families::make<double>(random, Boxes::clusters, 1500);
  const auto count = double(contact::all_pairs<double>(many).pairs.size());
  const double estimate = contact::sampled_pairs<double>(many, 0);
  CHECK(estimate > count / 2);
  CHECK(estimate < count * 3 / 2);
}

TEST_CASE("a profile holds the measured extents") {
  const std::vector<Aabb<float>> boxes{{{0, 0, 0}, {1, 2, 3}}, {{4, -2, 0}, {7, 4, 1}}};
  const auto profile = contact::profile_of<float>(boxes);
  CHECK(profile.count == 2);
  CHECK(profile.spread == Vector3<double>(4, 2, 0));
  CHECK(profile.mean_extent == Vector3<double>(2, 4, 2));
  CHECK(profile.mean_square_extent == Vector3<double>(5, 20, 5));
  CHECK(profile.largest_extent == Vector3<double>(3, 6, 3));
  CHECK(contact::expected_axis_share(profile, 2) == 1);
  const auto none = contact::profile_of<double>(std::vector<Aabb<double>>{});
  CHECK(none.count == 0);
  CHECK(contact::expected_touching_pairs(none) == 0);
}

TEST_CASE("the cheapest method by the model is almost as cheap as the cheapest by the count") {
  // Counted costs in the model's unit: comparisons, and half a comparison for each step of sorting.
  Random random(10);
  for (const Boxes family : families::all) {
    if (family == Boxes::huge) continue;  // squares of extents overflow: no profile
    for (const int n : {4, 12, 50, 200, 1000}) {
      const auto boxes = families::make<double>(random, family, n);
      const std::span<const Aabb<double>> view(boxes);
      const auto cost = contact::broad_phase_cost(view);
      const double sorting = n * contact::sorting_depth(static_cast<std::uint64_t>(n)) / 2;
      const auto counted = [&](contact::BroadPhase method) {
        const PairSearch search = contact::touching_pairs(view, method);
        const auto tests = double(search.box_tests);
        const auto other = double(search.other_steps);
        switch (method) {
          case contact::BroadPhase::sweep:
            return tests + 7 * sorting;
          case contact::BroadPhase::grid:
            return tests + other + sorting;
          case contact::BroadPhase::tree:
            return tests + other + 2 * sorting;
          default:
            return tests;
        }
      };
      double best = counted(contact::BroadPhase::all_pairs);
      for (const auto method :
           {contact::BroadPhase::sweep, contact::BroadPhase::grid, contact::BroadPhase::tree})
        best = std::min(best, counted(method));
      INFO(families::name(family) << ", " << n << " boxes: " << cost.all_pairs << ", " << cost.sweep
                                  << ", " << cost.grid << ", " << cost.tree);
      CHECK(counted(cost.cheapest()) <= 4 * best + 16);
      if (n == 4) CHECK(cost.cheapest() == contact::BroadPhase::all_pairs);
      if (n == 1000 && family == Boxes::scattered)
        CHECK(cost.cheapest() != contact::BroadPhase::all_pairs);
    }
  }
}

TEST_CASE("the bound of a grid counts what is no box with all") {
  const std::vector<Aabb<double>> boxes{
      {Vector3<double>::Zero(), Vector3<double>::Ones()},
      {Vector3<double>::Constant(100), Vector3<double>::Constant(99)}};
  contact::PairGrid<double> grid;
  grid.cell_edge = 4;
  CHECK(contact::grid_pairs<double>(boxes, grid).box_tests == 1);
  CHECK(contact::max_grid_tests<double>(boxes, grid) == 1);
}
