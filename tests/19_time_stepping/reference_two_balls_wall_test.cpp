// Two balls near a wall against fractions and conserved quantities (class (a) of the oracle).
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/block_count.hpp>
#include <contact/two_balls_wall.hpp>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/refusal.hpp"

using contact::TwoBallsAndWall;
using generators::Random;
using oracle::Rational;
using support::contains;
using support::refusal;

namespace {

TwoBallsAndWall<Rational> any_balls(Random& random, const Rational& e) {
  const auto part = [&random](int low, int high) {
    const int top = random.integer(low, high);
    return Rational(top) / random.integer(1, 7);
  };
  const Rational inner_mass = part(1, 20);
  const Rational outer_mass = part(1, 20);
  const Rational v1 = part(-9, 9);
  const Rational v2 = part(-9, 9);
  const Rational wall_gap = part(0, 9);
  const Rational ball_gap = part(0, 9);
  return contact::two_balls_and_wall<Rational>({inner_mass, v1}, {outer_mass, v2}, wall_gap,
                                               ball_gap, e);
}

}  // namespace

TEST_CASE("two elastic balls conserve energy, and m x² + M y² is a parabola in time") {
  // In the coordinates √m x and √M y the two balls are a point in a wedge that bounces without
  // loss, and its distance from the apex is that of a straight line: Q(t) = Q + 2 P t + 2 E t².
  Random random(1934);
  std::int64_t hits = 0;
  for (int i = 0; i < 500; ++i) {
    const auto start = any_balls(random, 1);
    const Rational t = Rational(random.integer(1, 40)) / 4;
    Rational left = t;
    const auto end = contact::two_balls_by_events<Rational>(start, left, 10000);
    REQUIRE(left == 0);
    const auto sums = [](const TwoBallsAndWall<Rational>& s) {
      const Rational x = s.wall_gap;
      const Rational y = s.wall_gap + s.ball_gap;
      const Rational& m = s.inner.mass;
      const Rational& n = s.outer.mass;
      const Rational& v = s.inner.velocity;
      const Rational& w = s.outer.velocity;
      return std::array<Rational, 3>{m * x * x + n * y * y, m * x * v + n * y * w,
                                     m * v * v + n * w * w};
    };
    const auto before = sums(start);
    const auto after = sums(end);
    REQUIRE(after[2] == before[2]);
    REQUIRE(after[1] == before[1] + before[2] * t);
    REQUIRE(after[0] == before[0] + 2 * before[1] * t + before[2] * t * t);
    REQUIRE(end.wall_gap >= 0);
    REQUIRE(end.ball_gap >= 0);
    hits += end.hits;
  }
  CHECK(hits > 500);
}

TEST_CASE("equal elastic balls move as if they passed through each other") {
  Random random(1935);
  for (int i = 0; i < 300; ++i) {
    auto start = any_balls(random, 1);
    start.outer.mass = start.inner.mass;
    const Rational t = Rational(random.integer(1, 40)) / 4;
    Rational left = t;
    const auto end = contact::two_balls_by_events<Rational>(start, left, 10000);
    Rational a = abs(Rational(start.wall_gap + start.inner.velocity * t));
    Rational b = abs(Rational(start.wall_gap + start.ball_gap + start.outer.velocity * t));
    if (b < a) std::swap(a, b);
    REQUIRE(end.wall_gap == a);
    REQUIRE(end.wall_gap + end.ball_gap == b);
  }
}

TEST_CASE("the numbers of collisions by events are the digits of pi") {
  for (const double ratio : {1.0, 2.0, 16.0, 100.0, 1000.0, 10000.0}) {
    auto blocks = contact::two_balls_and_wall<double>({1, 0}, {ratio, -1}, 1.0, 1.0, 1.0);
    double forever = 1e9;
    blocks = contact::two_balls_by_events(blocks, forever, 100000);
    CHECK(blocks.hits == *contact::count_collisions(ratio));
  }
}

TEST_CASE("a round of two balls and a wall has determinant e², and its trace decides") {
  Random random(1938);
  for (int i = 0; i < 400; ++i) {
    const double restitution = random.integer(0, 16) / 16.0;
    const double outer = random.integer(1, 64);
    const double inner = random.integer(1, 16);
    const Rational e = oracle::exact(restitution);
    const Rational m = oracle::exact(inner);
    const Rational n = oracle::exact(outer);
    const auto round = [&](const Rational& u, const Rational& w) {
      const auto after = contact::collide<Rational>({m, -e * u}, {n, w}, e);
      return std::pair<Rational, Rational>(after.first, after.second);
    };
    // Both move towards the wall, so that they collide; the map is linear.
    const auto one = round(-1, 0);
    const auto both = round(-1, -1);
    const Rational a = -one.first;
    const Rational c = -one.second;
    const Rational b = -both.first - a;
    const Rational d = -both.second - c;
    REQUIRE(a * d - b * c == e * e);
    REQUIRE(a + d == 1 - e + (1 + e) * (e * n - m) / (n + m));
    REQUIRE((a + d >= 2 * e) == contact::collapses(inner, outer, restitution));
  }
}

TEST_CASE("the polynomial decides whether there are infinitely many collisions") {
  Random random(1936);
  int endless = 0;
  int ending = 0;
  for (int i = 0; i < 400; ++i) {
    const double e = random.integer(1, 15) / 16.0;
    const double outer = random.integer(1, 64);
    const double inner = random.integer(1, 16);
    // Near the limit the vector of the velocities rotates so slowly that the last collision is
    // late.
    const double trace = 1 - e + (1 + e) * (e * outer - inner) / (outer + inner);
    if (trace < 2 * e && trace > 1.9 * e) continue;
    const auto start = contact::two_balls_and_wall<Rational>(
        {oracle::exact(inner), 0}, {oracle::exact(outer), -1}, 1, 1, oracle::exact(e));
    Rational time = 1000000000;
    const auto end = contact::two_balls_by_events<Rational>(start, time, 60);
    const bool stopped = time > 0;
    INFO("e = " << e << ", m = " << inner << ", M = " << outer);
    REQUIRE(contact::collapses(inner, outer, e) == stopped);
    (stopped ? endless : ending) += 1;
  }
  CHECK(endless > 50);
  CHECK(ending > 50);
  // At the limit: e = 1/2 and M = 8 m; e = 1/3 is not a double.
  CHECK(contact::collapses(1.0, 8.0, 0.5));
  CHECK_FALSE(contact::collapses(1.0, std::nextafter(8.0, 0.0), 0.5));
  CHECK_FALSE(contact::collapses(std::nextafter(1.0, 2.0), 8.0, 0.5));
  CHECK(contact::collapses(1.0, 1e-300, 0.0));
  CHECK_FALSE(contact::collapses(1e-300, 1e300, 1.0));
}

TEST_CASE("steps of two balls are exact without collisions, and find an overlap a step late") {
  Random random(1937);
  for (int i = 0; i < 200; ++i) {
    auto start = any_balls(random, 1);
    start.inner.velocity = Rational(random.integer(0, 3));
    start.outer.velocity = start.inner.velocity + Rational(random.integer(0, 3));
    const auto end = contact::two_balls_in_steps<Rational>(start, Rational(1) / 8, 16);
    REQUIRE(end.hits == 0);
    REQUIRE(end.wall_gap == start.wall_gap + 2 * start.inner.velocity);
  }
  // The overlap is found at the end of the step: the inner ball is 1 m inside the wall by then.
  const auto late = contact::two_balls_in_steps<Rational>(
      contact::two_balls_and_wall<Rational>({1, -4}, {1, 0}, 1, 100, 1), Rational(1) / 2, 1);
  CHECK(late.wall_gap == -1);
  CHECK(late.inner.velocity == 4);
}

TEST_CASE("invalid balls are refused by name") {
  const contact::LineBody<double> ball{1, 0};
  const contact::LineBody<double> wall{std::numeric_limits<double>::infinity(), 0};
  CHECK(contains(refusal([&] { contact::two_balls_and_wall(wall, ball, 0.0, 0.0, 1.0); }),
                 "inner.mass"));
  CHECK(contains(refusal([&] { contact::two_balls_and_wall(ball, wall, 0.0, 0.0, 1.0); }),
                 "outer.mass"));
  CHECK(contains(refusal([&] { contact::two_balls_and_wall(ball, ball, -1.0, 0.0, 1.0); }),
                 "wall_gap = -1"));
  CHECK(contains(refusal([&] { contact::two_balls_and_wall(ball, ball, 0.0, -1.0, 1.0); }),
                 "ball_gap"));
  CHECK(contains(refusal([&] { contact::two_balls_and_wall(ball, ball, 0.0, 0.0, 2.0); }),
                 "restitution"));
}
