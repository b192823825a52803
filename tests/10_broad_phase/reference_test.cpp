// Every reference function of the chapter. Pairs are held against fractions made of the stored
// numbers; a box that encloses something is held against the thing itself, in fractions; a cost
// that is said to be exact is counted. Decisions have no tolerance.
#include <algorithm>
#include <array>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/broad_phase_cost.hpp>
#include <contact/outward.hpp>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

#include "families.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

using contact::Aabb;
using contact::BoxPair;
using contact::PairSearch;
using contact::Vector3;
using families::Boxes;
using generators::Random;
using oracle::Rational;

namespace {

/// Whether boxes touch, in fractions: the common part of their ranges is not empty on any axis.
template <class S>
bool touch(const Aabb<S>& a, const Aabb<S>& b) {
  for (int k = 0; k < 3; ++k) {
    const Rational from = std::max(oracle::exact(a.low(k)), oracle::exact(b.low(k)));
    const Rational to = std::min(oracle::exact(a.high(k)), oracle::exact(b.high(k)));
    if (from > to) return false;
  }
  return true;
}

template <class S>
std::vector<BoxPair> right_pairs(const std::vector<Aabb<S>>& boxes) {
  std::vector<BoxPair> pairs;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    for (std::uint32_t j = i + 1; j < boxes.size(); ++j) {
      if (touch(boxes[i], boxes[j])) pairs.push_back({i, j});
    }
  }
  return pairs;
}

/// How many pairs overlap on one axis, one by one.
template <class S>
std::uint64_t overlaps(const std::vector<Aabb<S>>& boxes, int axis) {
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = i + 1; j < boxes.size(); ++j) {
      if (boxes[i].low(axis) <= boxes[j].high(axis) && boxes[j].low(axis) <= boxes[i].high(axis))
        ++count;
    }
  }
  return count;
}

}  // namespace

TEMPLATE_TEST_CASE("sums are rounded outwards to the next number, and no further", "", float,
                   double) {
  using S = TestType;
  Random random(1);
  const S infinity = std::numeric_limits<S>::infinity();
  for (int i = 0; i < generators::tried(4000); ++i) {
    const int range = i % 2 == 0 ? 4 : std::numeric_limits<S>::max_exponent - 2;
    const S a = static_cast<S>(random.magnitude(-range, range));
    S b = static_cast<S>(random.magnitude(-range, range));
    if (i % 5 == 0) b = -std::nextafter(a, S(0));
    const Rational sum = oracle::exact(a) + oracle::exact(b);
    const S up = contact::sum_up(a, b);
    const S down = contact::sum_down(a, b);
    CHECK(oracle::exact(up) >= sum);
    CHECK(oracle::exact(std::nextafter(up, -infinity)) < sum);
    CHECK(oracle::exact(down) <= sum);
    CHECK(oracle::exact(std::nextafter(down, infinity)) > sum);
  }
  const S largest = std::numeric_limits<S>::max();
  CHECK(contact::sum_up(largest, largest) == infinity);
  CHECK(contact::sum_down(largest, largest) == largest);
  CHECK(contact::sum_up(-largest, -largest) == -largest);
  CHECK(contact::sum_down(-largest, -largest) == -infinity);
  CHECK(contact::sum_up(largest, std::numeric_limits<S>::denorm_min()) == infinity);
  CHECK(contact::sum_up(largest, -largest) == 0);
}

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
      // Any grid will do, also one that suits nothing.
      for (const double edge : {1e-3, 0.3, 1.0, 77.0, 1e30}) {
        const contact::PairGrid<S> grid{families::place<S>(random, 5), static_cast<S>(edge)};
        CHECK(contact::grid_pairs(view, grid).pairs == right);
      }
      for (const auto method : {contact::BroadPhase::all_pairs, contact::BroadPhase::sweep,
                                contact::BroadPhase::grid, contact::BroadPhase::tree})
        CHECK(contact::touching_pairs(view, method).pairs == right);
    }
  }
  CHECK(found > static_cast<std::size_t>(generators::tried(1000)));
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

TEST_CASE("a tree tells what a box touches") {
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

TEST_CASE("a sweep from step to step finds what a fresh one finds, and counts what moved") {
  Random random(5);
  for (const Boxes family : families::all) {
    auto boxes = families::make<double>(random, family, 60);
    contact::IncrementalSweep<double> sweep(1);
    CHECK(sweep.axis() == 1);
    sweep.update(boxes);
    CHECK(sweep.resorted());
    // The order by low end, then place: the only one there is.
    const auto order = [&boxes] {
      std::vector<std::uint32_t> places;
      for (std::uint32_t i = 0; i < boxes.size(); ++i) places.push_back(i);
      std::stable_sort(places.begin(), places.end(), [&](std::uint32_t i, std::uint32_t j) {
        return boxes[i].low(1) < boxes[j].low(1);
      });
      return places;
    };
    for (int step = 0; step < 20; ++step) {
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

TEST_CASE("an order turned round is sorted anew instead of move by move") {
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

TEST_CASE("what is said to be the exact cost is what is counted") {
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
    // Where coordinates overflow or are far beyond the grid the bound is not claimed.
    if (family == Boxes::huge || family == Boxes::tiny) continue;
    for (int round = 0; round < generators::tried(24); ++round) {
      const auto boxes = families::make<double>(random, family, random.integer(2, 400));
      const std::span<const Aabb<double>> view(boxes);
      const auto grid = contact::grid_for(view);
      const std::uint64_t bound = contact::most_grid_tests(view, grid);
      INFO(families::name(family) << ", " << boxes.size() << " boxes");
      CHECK(contact::grid_pairs(view, grid).box_tests <= bound);
      if (2 * bound < contact::pair_count(boxes.size())) ++useful;
    }
  }
  CHECK(useful > generators::tried(24));
}

TEST_CASE("expected comparisons are the mean of many counts") {
  // Extents are fixed, lower ends by chance in [0, L): the mean of m counts is within six standard
  // errors of the expectation; the spread of the counts is measured beside their mean.
  Random random(8);
  const int n = 40;
  const int rounds = 4000;
  for (const double largest : {0.05, 0.4, 1.0}) {
    std::vector<Vector3<double>> extents;
    contact::BoxProfile profile;
    profile.count = n;
    profile.spread = Vector3<double>(8, 8, 8);
    for (int i = 0; i < n; ++i) {
      // One size for all on axis 0; different ones on axis 1; on axis 2 some exceed the spread.
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

TEST_CASE("few boxes are all in the sample, and of many the estimate is near the count") {
  Random random(13);
  for (const Boxes family : families::all) {
    const auto few = families::make<double>(random, family, 32);
    CHECK(contact::sampled_pairs<double>(few, 0) == double(right_pairs(few).size()));
  }
  CHECK(contact::sampled_pairs<double>({}, 1) == 0);
  // Each sampled box meets a number of others between 0 and n − 1; in crowds of equal size the mean
  // of 32 is within a half of the mean of all.
  const auto many = families::make<double>(random, Boxes::clusters, 1500);
  const auto count = double(contact::all_pairs<double>(many).pairs.size());
  const double estimate = contact::sampled_pairs<double>(many, 0);
  CHECK(estimate > count / 2);
  CHECK(estimate < count * 3 / 2);
}

TEST_CASE("a profile is what was measured") {
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

TEST_CASE("the cheapest method by the model is not much dearer than the cheapest by the count") {
  // Counted costs in the model's unit: comparisons, and half for each step of sorting.
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

TEMPLATE_TEST_CASE("the box of a sphere holds it, and no smaller one does", "", float, double) {
  using S = TestType;
  Random random(11);
  const S infinity = std::numeric_limits<S>::infinity();
  for (int i = 0; i < generators::tried(3000); ++i) {
    const int range = i % 3 == 0 ? 60 : 3;
    contact::Sphere<S> sphere;
    for (int k = 0; k < 3; ++k) sphere.centre(k) = static_cast<S>(random.magnitude(-range, range));
    sphere.radius = static_cast<S>(std::abs(random.magnitude(-range, range)));
    const auto box = contact::aabb_of_sphere(sphere);
    const auto exact = oracle::exact(sphere);
    for (int k = 0; k < 3; ++k) {
      const Rational low = exact.centre(k) - exact.radius;
      const Rational high = exact.centre(k) + exact.radius;
      CHECK(oracle::exact(box.low(k)) <= low);
      CHECK(oracle::exact(std::nextafter(box.low(k), infinity)) > low);
      CHECK(oracle::exact(box.high(k)) >= high);
      CHECK(oracle::exact(std::nextafter(box.high(k), -infinity)) < high);
    }
    Vector3<S> way;
    for (int k = 0; k < 3; ++k) way(k) = static_cast<S>(random.magnitude(-range, range));
    const auto swept = contact::aabb_of_swept_sphere(sphere, way);
    const S margin = sphere.radius / 3;
    const auto moved = contact::aabb_of_swept_box(box, way, margin);
    for (int k = 0; k < 3; ++k) {
      for (const Rational& t : {Rational(0), Rational(1), Rational(1) / 3}) {
        const Rational middle = exact.centre(k) + t * oracle::exact(way(k));
        CHECK(oracle::exact(swept.low(k)) <= middle - exact.radius);
        CHECK(oracle::exact(swept.high(k)) >= middle + exact.radius);
        const Rational shift = t * oracle::exact(way(k));
        CHECK(oracle::exact(moved.low(k)) <=
              oracle::exact(box.low(k)) + shift - oracle::exact(margin));
        CHECK(oracle::exact(moved.high(k)) >=
              oracle::exact(box.high(k)) + shift + oracle::exact(margin));
      }
      // Two roundings outwards, each by less than one step at the size of what is added.
      const Rational size = abs(exact.centre(k)) + abs(oracle::exact(way(k))) + exact.radius;
      const Rational room = 4 * oracle::exact(contact::tolerance::unit_roundoff<S>) * size;
      const Rational least =
          std::min(exact.centre(k), Rational(exact.centre(k) + oracle::exact(way(k))));
      CHECK(oracle::exact(swept.low(k)) >= least - exact.radius - room);
    }
  }
}

TEMPLATE_TEST_CASE("the box of a turned box holds its corners", "", float, double) {
  using S = TestType;
  Random random(12);
  for (int i = 0; i < generators::tried(2000); ++i) {
    Vector3<S> normal = families::place<S>(random, 1);
    if (normal == Vector3<S>::Zero()) normal = Vector3<S>::UnitX();
    const auto frame = contact::frame_on_normal<S>(families::place<S>(random, 1e3), normal);
    const Vector3<S> half = families::place<S>(random, i % 2 == 0 ? 1 : 1e-40).cwiseAbs();
    const auto box = contact::aabb_of_turned_box(frame, half);
    for (int k = 0; k < 3; ++k) {
      Rational reach = 0;
      for (int j = 0; j < 3; ++j)
        reach += abs(oracle::exact(frame.axes(k, j))) * oracle::exact(half(j));
      const Rational centre = oracle::exact(frame.origin(k));
      CHECK(oracle::exact(box.low(k)) <= centre - reach);
      CHECK(oracle::exact(box.high(k)) >= centre + reach);
      const Rational u = oracle::exact(contact::tolerance::unit_roundoff<S>);
      const Rational room = 16 * u * reach + 2 * u * (abs(centre) + reach) +
                            4 * oracle::exact(std::numeric_limits<S>::denorm_min());
      CHECK(oracle::exact(box.high(k)) <= centre + reach + room);
    }
  }
}

TEST_CASE("boxes round points and boxes") {
  const std::vector<Vector3<double>> points{{1, 5, -2}, {3, -1, 0}, {2, 2, 2}};
  const auto box = contact::aabb_of_points<double>(points);
  CHECK(box.low == Vector3<double>(1, -1, -2));
  CHECK(box.high == Vector3<double>(3, 5, 2));
  const auto both = contact::enclosing_box(box, {{0, 0, 0}, {9, 1, 1}});
  CHECK(both.low == Vector3<double>(0, -1, -2));
  CHECK(both.high == Vector3<double>(9, 5, 2));
}

TEST_CASE("what is no box is refused, with the argument and the value") {
  using V = Vector3<double>;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const double largest = std::numeric_limits<double>::max();
  const auto says = [](auto make, const std::string& words) {
    try {
      make();
    } catch (const std::invalid_argument& error) {
      INFO(error.what());
      CHECK(std::string(error.what()).find(words) != std::string::npos);
      return;
    }
    FAIL("nothing was thrown; expected: " << words);
  };
  using contact::aabb_from_corners;
  says([&] { aabb_from_corners<double>(V(0, nan, 0), V(1, 1, 1)); }, "low = (0, nan, 0)");
  says([&] { aabb_from_corners<double>(V(0, 0, 0), V(1, infinity, 1)); }, "high = (1, inf, 1)");
  says([&] { aabb_from_corners<double>(V(0, 2, 0), V(1, 1, 1)); }, "low = (0, 2, 0)");
  says([&] { contact::aabb_of_points<double>({}); }, "points = {}");
  says([&] { contact::aabb_of_sphere<double>({V(0, 0, 0), -1}); }, "radius = -1");
  says([&] { contact::aabb_of_sphere<double>({V(0, 0, 0), nan}); }, "radius = nan");
  says([&] { contact::aabb_of_sphere<double>({V(nan, 0, 0), 1}); }, "centre = (nan, 0, 0)");
  says([&] { contact::aabb_of_sphere<double>({V(largest, 0, 0), largest}); }, "its box overflows");
  says(
      [&] {
        contact::aabb_of_swept_sphere<double>({V(0, 0, 0), 1}, V(0, infinity, 0));
      },
      "displacement = (0, inf, 0)");
  says(
      [&] {
        contact::aabb_of_swept_sphere<double>({V(largest, 0, 0), 1}, V(largest, 0, 0));
      },
      "its box overflows");
  says([&] { contact::aabb_of_swept_box<double>({}, V(0, 0, 0), -1); }, "margin = -1");
  says([&] { contact::aabb_of_turned_box<double>({}, V(1, -1, 1)); }, "half_lengths = (1, -1, 1)");
  says([&] { contact::aabb_of_turned_box<double>({}, V(1, largest, 1)); }, "its box overflows");
  // A flat box and a point are boxes.
  CHECK(contact::boxes_touch(aabb_from_corners<double>(V(1, 1, 1), V(1, 1, 1)),
                             aabb_from_corners<double>(V(0, 0, 1), V(2, 2, 1))));
}
