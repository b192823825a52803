// Every method of the broad phase against all pairs.
#include <algorithm>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <contact/broad_phase_cost.hpp>
#include <limits>
#include <span>
#include <utility>
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
using reference::touch;

TEMPLATE_TEST_CASE("every broad phase finds the same pairs, and they are the right ones", "", float,
                   double) {
  using S = TestType;
  Random random(2);
  std::size_t found = 0;
  for (const Boxes family : families::all) {
    for (int round = 0; round < generators::tried(24); ++round) {
      const int n = round % 4 == 0 ? round / 4 : random.integer(2, 60);
      const auto boxes = families::make<S>(random, family, n);
      const std::span<const Aabb<S>> view(boxes);
      const auto right = right_pairs(boxes);
      found += right.size();
      INFO(families::name(family) << ", " << n << " boxes");
      CHECK(contact::all_pairs(view).pairs == right);
      CHECK(contact::grid_pairs(view).pairs == right);
      CHECK(contact::sweep_pairs(view).pairs == right);
      CHECK(contact::tree_pairs(view).pairs == right);
      for (int axis = 0; axis < 3; ++axis) CHECK(contact::sweep_pairs(view, axis).pairs == right);
      // Any grid gives the pairs, also one that does not suit the boxes.
      for (const double edge : {1e-3, 0.3, 1.0, 77.0, 1e30}) {
        const contact::PairGrid<S> grid{families::in_box<S>(random, 5), static_cast<S>(edge)};
        CHECK(contact::grid_pairs(view, grid).pairs == right);
      }
      for (const auto method : {contact::BroadPhase::all_pairs, contact::BroadPhase::sweep,
                                contact::BroadPhase::grid, contact::BroadPhase::tree})
        CHECK(contact::touching_pairs(view, method).pairs == right);
    }
  }
  CHECK(found > static_cast<std::size_t>(generators::tried(1000)));
}

TEST_CASE("a list with errors: every method has the pairs of all pairs") {
  Random random(14);
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int round = 0; round < generators::tried(80); ++round) {
    auto boxes = families::make<double>(random, Boxes::scattered, 30);
    for (int error = 0; error < 4; ++error) {
      const int which = random.integer(0, 29);
      const int axis = random.integer(0, 2);
      Aabb<double>& box = boxes[static_cast<std::size_t>(which)];
      if (error == 0) box.low(axis) = nan;
      if (error == 1) box.high(axis) = infinity;
      if (error == 2) std::swap(box.low(axis), box.high(axis));
      if (error == 3) box.low(axis) = -infinity;
    }
    const std::span<const Aabb<double>> view(boxes);
    const auto all = contact::all_pairs(view).pairs;
    CHECK(contact::grid_pairs(view).pairs == all);
    CHECK(contact::sweep_pairs(view).pairs == all);
    CHECK(contact::tree_pairs(view).pairs == all);
    contact::IncrementalSweep<double> sweep(round % 3);
    CHECK(sweep.update(view).pairs == all);
    CHECK(sweep.update(view).pairs == all);
  }
}

TEST_CASE("entries are sorted by their cells, and keep their order within one") {
  Random random(15);
  for (const int bits : {0, 1, 5, 12, 13, 33, 63}) {
    for (const int n : {0, 1, 7, 300, 5000}) {
      std::vector<contact::detail::CellEntry> entries;
      for (int i = 0; i < n; ++i) {
        const std::uint64_t cell = random.bits() & ((std::uint64_t{1} << bits) - 1);
        entries.push_back({cell, static_cast<std::uint32_t>(i)});
      }
      auto right = entries;
      std::stable_sort(right.begin(), right.end(),
                       [](const auto& x, const auto& y) { return x.cell < y.cell; });
      contact::detail::sort_by_cell(entries, bits);
      CHECK(std::equal(
          entries.begin(), entries.end(), right.begin(), right.end(),
          [](const auto& x, const auto& y) { return x.cell == y.cell && x.box == y.box; }));
    }
  }
}

TEST_CASE("large lists: the methods agree with all pairs, and pairs are in order") {
  Random random(3);
  for (const Boxes family : families::all) {
    const auto boxes = families::make<double>(random, family, generators::tried(1600));
    const std::span<const Aabb<double>> view(boxes);
    const PairSearch all = contact::all_pairs(view);
    INFO(families::name(family));
    CHECK(std::is_sorted(all.pairs.begin(), all.pairs.end()));
    CHECK(std::adjacent_find(all.pairs.begin(), all.pairs.end()) == all.pairs.end());
    CHECK(contact::grid_pairs(view).pairs == all.pairs);
    CHECK(contact::sweep_pairs(view).pairs == all.pairs);
    CHECK(contact::tree_pairs(view).pairs == all.pairs);
  }
}

TEST_CASE("a tree finds the boxes that touch a given one") {
  Random random(4);
  for (const Boxes family : families::all) {
    const auto boxes = families::make<double>(random, family, 70);
    const auto questions = families::make<double>(random, family, 30);
    const contact::BoxTree<double> tree(boxes);
    for (const auto& box : questions) {
      std::vector<std::uint32_t> right;
      for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        if (touch(boxes[i], box)) right.push_back(i);
      }
      CHECK(tree.touching(box) == right);
    }
  }
  CHECK(contact::BoxTree<double>(std::vector<Aabb<double>>{}).touching({}).empty());
}

TEST_CASE("an incremental sweep finds the pairs of a fresh one, and counts exchanges") {
  Random random(5);
  for (const Boxes family : families::all) {
    auto boxes = families::make<double>(random, family, 40);
    contact::IncrementalSweep<double> sweep(1);
    CHECK(sweep.axis() == 1);
    sweep.update(boxes);
    CHECK(sweep.resorted());
    // The order by low end, then by index, which is unique.
    const auto order = [&boxes] {
      std::vector<std::uint32_t> indices;
      for (std::uint32_t i = 0; i < boxes.size(); ++i) indices.push_back(i);
      std::stable_sort(indices.begin(), indices.end(), [&](std::uint32_t i, std::uint32_t j) {
        return boxes[i].low(1) < boxes[j].low(1);
      });
      return indices;
    };
    for (int step = 0; step < generators::tried(16); ++step) {
      const auto before = order();
      for (auto& box : boxes) {
        const double shift = random.uniform(-0.2, 0.2);
        const Vector3<double> by(0, shift, 0);
        box = {Vector3<double>(box.low + by), Vector3<double>(box.high + by)};
      }
      const PairSearch search = sweep.update(boxes);
      CHECK_FALSE(sweep.resorted());
      CHECK(search.pairs == right_pairs(boxes));
      CHECK(search.box_tests == overlaps(boxes, 1));
      const auto after = order();
      std::vector<std::size_t> rank(boxes.size());
      for (std::size_t k = 0; k < after.size(); ++k) rank[after[k]] = k;
      std::uint64_t exchanged = 0;
      for (std::size_t i = 0; i < before.size(); ++i) {
        for (std::size_t j = i + 1; j < before.size(); ++j) {
          if (rank[before[i]] > rank[before[j]]) ++exchanged;
        }
      }
      CHECK(search.other_steps == exchanged);
    }
    boxes.pop_back();
    CHECK(sweep.update(boxes).pairs == right_pairs(boxes));
    CHECK(sweep.resorted());
  }
}

TEST_CASE("a reversed order is sorted from scratch") {
  std::vector<Aabb<double>> boxes;
  for (int i = 0; i < 400; ++i)
    boxes.push_back({Vector3<double>(i, 0, 0), Vector3<double>(i + 1.0, 1, 1)});
  contact::IncrementalSweep<double> sweep(0);
  sweep.update(boxes);
  CHECK(sweep.update(boxes).other_steps == 0);
  std::reverse(boxes.begin(), boxes.end());
  const PairSearch search = sweep.update(boxes);
  CHECK(sweep.resorted());
  CHECK(search.pairs.size() == 399);
  CHECK(search.pairs == contact::sweep_pairs<double>(boxes, 0).pairs);
  CHECK(search.other_steps < 400 * 399 / 2);
}

TEMPLATE_TEST_CASE("a grid for millions of points has at most 2^21 cells along an axis", "", float,
                   double) {
  using S = TestType;
  // Points 1 m apart on a line: with an edge of 1 m, all from the 2^21st on would share the last
  // cell.
  const auto edge = [](std::size_t n) {
    return contact::detail::cell_edge_for<S>({S(n - 1) / 2, 0, 0}, S(0), n);
  };
  const std::size_t last = contact::last_grid_cell;
  CHECK(edge(1000) == 1);
  CHECK(edge(last + 1) == 1);
  CHECK(edge(last + 2) == 2);
  CHECK(edge(std::size_t{1} << 23) == 4);
}

TEMPLATE_TEST_CASE("a grid has at most one cell more than boxes", "", float, double) {
  using S = TestType;
  Random random(6);
  for (int round = 0; round < generators::tried(400); ++round) {
    std::vector<Aabb<S>> points;
    const int n = random.integer(2, 30);
    const Vector3<S> spread = families::in_box<S>(random, 20);
    for (int i = 0; i < n; ++i) {
      const Vector3<S> share = families::in_box<S>(random, 1);
      const Vector3<S> at = spread.cwiseProduct(share).array().round();
      points.push_back({at, at});
    }
    const auto grid = contact::grid_for<S>(points);
    Vector3<S> high = points.front().high;
    for (const Aabb<S>& point : points) high = high.cwiseMax(point.high);
    double cells = 1;
    for (int k = 0; k < 3; ++k)
      cells *= contact::grid_cell(S(high(k)), S(grid.origin(k)), grid.cell_edge) + 1.0;
    REQUIRE(cells <= n + 1);
  }
}
