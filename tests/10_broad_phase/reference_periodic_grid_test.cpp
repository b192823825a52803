// periodic_grid.hpp: boxes that touch across the border of a period, in fractions.
#include <algorithm>
#include <array>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/periodic_grid.hpp>
#include <limits>
#include <set>
#include <span>
#include <stdexcept>
#include <vector>

#include "families.hpp"
#include "reference.hpp"
#include "support/generators.hpp"

namespace {

using contact::Aabb;
using contact::BoxPair;
using contact::PeriodicGrid;
using contact::Vector3;
using generators::Random;
using oracle::Rational;

/// The largest integer that is at most x.
Rational floor_of(const Rational& x) {
  namespace mp = boost::multiprecision;
  const mp::mpz_int n = mp::numerator(x), d = mp::denominator(x);
  mp::mpz_int q = n / d;  // towards zero
  if (q * d > n) --q;
  return Rational(q);
}

/// Whether an integer k has a.low ≤ b.high + k period and b.low + k period ≤ a.high, on each axis.
template <class S>
bool touch_periodic(const Aabb<S>& a, const Aabb<S>& b, const Vector3<S>& period) {
  for (int k = 0; k < 3; ++k) {
    const Rational p = oracle::exact(period(k));
    const Rational from = (oracle::exact(a.low(k)) - oracle::exact(b.high(k))) / p;
    const Rational to = (oracle::exact(a.high(k)) - oracle::exact(b.low(k))) / p;
    if (floor_of(to) < from) return false;
  }
  return true;
}

template <class S>
std::vector<BoxPair> right_pairs_periodic(const std::vector<Aabb<S>>& boxes,
                                          const Vector3<S>& period) {
  std::vector<BoxPair> pairs;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    for (std::uint32_t j = i + 1; j < boxes.size(); ++j) {
      if (touch_periodic(boxes[i], boxes[j], period)) pairs.push_back({i, j});
    }
  }
  return pairs;
}

template <class S>
Vector3<S> drawn_period(Random& random) {
  Vector3<S> period;
  for (int k = 0; k < 3; ++k) {
    const int whole = random.integer(1, 9);
    const double any = random.uniform(0.3, 12);
    const int kind = random.integer(0, 2);
    period(k) = kind == 0 ? S(whole) : static_cast<S>(kind == 1 ? whole * 0.1 : any);
  }
  return period;
}

constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();
constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

TEMPLATE_TEST_CASE("a cell of a period is the floor of the exact quotient", "", float, double) {
  using S = TestType;
  Random random(31);
  const std::array<std::uint32_t, 6> counts{1, 2, 3, 7, 10, contact::max_periodic_cells};
  int on_borders = 0;
  for (int i = 0; i < generators::tried(4000); ++i) {
    const S period = drawn_period<S>(random)(0);
    const std::uint32_t cells = counts[static_cast<std::size_t>(random.integer(0, 5))];
    const int border = random.integer(-30, 30);
    const int nudge = random.integer(-1, 1);
    S x = period / static_cast<S>(cells) * static_cast<S>(border);
    if (nudge != 0) x = std::nextafter(x, static_cast<S>(nudge * largest));
    const Rational quotient = oracle::exact(x) * cells / oracle::exact(period);
    const Rational floor = floor_of(quotient);
    if (floor == quotient) ++on_borders;
    const Rational wrapped = floor - cells * floor_of(floor / cells);
    INFO(x << " of " << period << " in " << cells << " cells");
    REQUIRE(Rational(contact::periodic_cell<S>(x, period, cells)) == wrapped);
  }
  CHECK(on_borders > generators::tried(400));
}

TEST_CASE("a cell of a period at zero, below it, and many periods away") {
  CHECK(contact::periodic_cell<double>(0.0, 8, 4) == 0);
  CHECK(contact::periodic_cell<double>(-0.0, 8, 4) == 0);
  CHECK(contact::periodic_cell<double>(-smallest, 8, 4) == 3);
  CHECK(contact::periodic_cell<double>(8, 8, 4) == 0);
  CHECK(contact::periodic_cell<double>(std::nextafter(8.0, 0.0), 8, 4) == 3);
  CHECK(contact::periodic_cell<double>(-8, 8, 4) == 0);
  CHECK(contact::periodic_cell<double>(0x1p53 + 2, 8, 4) == 1);
  CHECK(contact::periodic_cell<double>(3 * smallest, 4 * smallest, 4) == 3);
  CHECK(contact::periodic_cell<double>(infinite, 8, 4) == 0);
  // Modulo 20, powers of two from 2^2 on repeat after four: 2^1023 is 8, as 2^3 is.
  CHECK(contact::periodic_cell<double>(0x1p1023, 20, 20) == 8);
}

TEST_CASE("neighbours of a cell are different, and each is a neighbour of the other") {
  for (std::uint32_t x = 1; x <= 4; ++x) {
    for (std::uint32_t y = 1; y <= 4; ++y) {
      const PeriodicGrid<double> grid{Vector3<double>::Ones(), {x, y, 3}};
      for (std::uint32_t i = 0; i < x; ++i) {
        for (std::uint32_t j = 0; j < y; ++j) {
          const std::array<std::uint32_t, 3> cell{i, j, 2};
          const auto around = contact::periodic_neighbours(cell, grid);
          const std::set<std::array<std::uint32_t, 3>> different(around.begin(), around.end());
          CHECK(different.size() == around.size());
          CHECK(around.size() == std::size_t{std::min(x, 3u)} * std::min(y, 3u) * 3);
          CHECK(different.count(cell) == 1);
          for (const auto& other : around) {
            const auto back = contact::periodic_neighbours(other, grid);
            CHECK(std::count(back.begin(), back.end(), cell) == 1);
          }
        }
      }
    }
  }
}

TEMPLATE_TEST_CASE("periodic grid: the pairs are those of fractions", "", float, double) {
  using S = TestType;
  Random random(32);
  std::size_t found = 0, across = 0;
  for (const families::Boxes family : families::all) {
    for (int round = 0; round < generators::tried(16); ++round) {
      const auto boxes = families::make<S>(random, family, random.integer(0, 24));
      const std::span<const Aabb<S>> view(boxes);
      const Vector3<S> period = drawn_period<S>(random);
      const auto right = right_pairs_periodic(boxes, period);
      INFO(families::name(family) << ", " << boxes.size() << " boxes");
      REQUIRE(contact::periodic_all_pairs(view, period).pairs == right);
      PeriodicGrid<S> grid = contact::periodic_grid_for(view, period);
      REQUIRE(contact::periodic_grid_pairs(view, grid).pairs == right);
      for (std::uint32_t& cells : grid.cells)
        cells = static_cast<std::uint32_t>(random.integer(1, 5));
      const auto search = contact::periodic_grid_pairs(view, grid);
      REQUIRE(search.pairs == right);
      // No pair twice.
      REQUIRE(search.box_tests <= contact::all_pairs(view).box_tests);
      found += right.size();
      across += right.size() - contact::all_pairs(view).pairs.size();
    }
  }
  CHECK(found > std::size_t(generators::tried(1000)));
  CHECK(across > std::size_t(generators::tried(300)));
}

TEST_CASE("a periodic grid compares few pairs, and those of a full row once") {
  // 8³ unit cubes fill a period: each touches its 26 neighbours, also across the border.
  for (const int side : {1, 2, 3, 8}) {
    std::vector<Aabb<double>> boxes;
    for (int i = 0; i < side * side * side; ++i) {
      const Vector3<double> low(i / (side * side), i / side % side, i % side);
      boxes.push_back({low, low + Vector3<double>::Ones()});
    }
    const auto cells = static_cast<std::uint32_t>(side);
    const PeriodicGrid<double> grid{Vector3<double>::Constant(side), {cells, cells, cells}};
    const auto search = contact::periodic_grid_pairs<double>(boxes, grid);
    const std::size_t along = std::min<std::size_t>(cells, 3);
    const std::size_t pairs = boxes.size() * (along * along * along - 1) / 2;
    CHECK(search.pairs.size() == pairs);
    CHECK(search.box_tests == pairs);
  }
}

TEST_CASE("whole periods of shift change no pair") {
  Random random(33);
  const Vector3<double> period(5, 3, 7);
  std::vector<Aabb<double>> boxes;
  for (int i = 0; i < 40; ++i) {
    const auto low = families::whole_in_box<double>(random, 20);
    const Vector3<double> extent = families::whole_in_box<double>(random, 2).cwiseAbs();
    boxes.push_back({low, low + extent});
  }
  const auto right = contact::periodic_all_pairs<double>(boxes, period).pairs;
  CHECK(right.size() > 40);
  for (Aabb<double>& box : boxes) {
    const auto periods = families::whole_in_box<double>(random, 1 << 30);
    const Vector3<double> shift = periods.cwiseProduct(period);
    box = {Vector3<double>(box.low + shift), Vector3<double>(box.high + shift)};
  }
  const auto grid = contact::periodic_grid_for<double>(boxes, period);
  CHECK(contact::periodic_grid_pairs<double>(boxes, grid).pairs == right);
}

TEST_CASE("boxes at the ends of the numbers touch periodically, exactly") {
  const auto flat = [](double from, double to) {
    return Aabb<double>{Vector3<double>(from, 0, 0), Vector3<double>(to, 1, 1)};
  };
  const auto touch = [](const Aabb<double>& a, const Aabb<double>& b, double period) {
    const Vector3<double> p(period, 4, 4);
    const bool right = touch_periodic(a, b, p);
    CHECK(contact::boxes_touch_periodic(a, b, p) == right);
    CHECK(contact::boxes_touch_periodic(b, a, p) == right);
    return right;
  };
  CHECK(touch(flat(0, 1), flat(7, 8), 8));
  CHECK_FALSE(touch(flat(0, 1), flat(7, std::nextafter(8.0, 0.0)), 8));
  CHECK(touch(flat(smallest, smallest), flat(-2 * smallest, -2 * smallest), 3 * smallest));
  CHECK_FALSE(touch(flat(smallest, smallest), flat(0, 0), 3 * smallest));
  CHECK(touch(flat(-largest, -largest), flat(largest, largest), largest));
  CHECK(touch(flat(-largest, largest), flat(3, 3), largest));
  CHECK(touch(flat(0, 0.1), flat(0x1p1000, 0x1p1000), 0.3) ==
        touch(flat(0x1p1000, 0x1p1000), flat(0, 0.1), 0.3));
  CHECK_FALSE(
      contact::boxes_touch_periodic(flat(0, infinite), flat(0, 1), Vector3<double>(8, 8, 8)));
  CHECK_FALSE(contact::boxes_touch_periodic(flat(0, 1), flat(0, 1), Vector3<double>(0, 8, 8)));
}

TEST_CASE("a periodic grid refuses a period, boxes and cells that are none") {
  const Vector3<double> period(1, 2, 3);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Aabb<double>> none;
  for (const double wrong : {0.0, -1.0, nan, infinite}) {
    const Vector3<double> p(1, wrong, 1);
    CHECK_THROWS_AS(contact::periodic_all_pairs<double>(none, p), std::invalid_argument);
    CHECK_THROWS_AS(contact::periodic_grid_for<double>(none, p), std::invalid_argument);
  }
  const std::vector<Aabb<double>> reversed{{Vector3<double>::Ones(), Vector3<double>::Zero()}};
  CHECK_THROWS_AS(contact::periodic_all_pairs<double>(reversed, period), std::invalid_argument);
  for (const std::uint32_t cells : {0u, contact::max_periodic_cells + 1}) {
    const PeriodicGrid<double> grid{period, {1, cells, 1}};
    CHECK_THROWS_AS(contact::periodic_grid_pairs<double>(none, grid), std::invalid_argument);
  }
  CHECK(contact::periodic_grid_pairs<double>(none, {period, {1, 2, 3}}).pairs.empty());
}
