// The exact times of moving points, with which methods are compared: by definition at sampled
// times, and by motions that cannot change them.
#include <catch2/catch_test_macros.hpp>

#include <array>
#include <cstddef>
#include <optional>

#include "families_points.hpp"
#include "moving_truth.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

namespace moving_truth_test {
namespace {

using moving_truth::Four;
using moving_truth::Root;
using oracle::Rational;

Four four_of(const families::MovingPoints& p) {
  Four four;
  for (std::size_t k = 0; k < 4; ++k) {
    four.start[k] = oracle::exact(p.start[k]);
    four.displacement[k] = oracle::exact(p.end[k]) - four.start[k];
  }
  return four;
}
/// Its interval is narrowed until both ends round alike.
std::optional<Root> first(const Four& four, bool edges) {
  auto t = edges ? moving_truth::edge_edge(four) : moving_truth::vertex_face(four);
  if (t) t->nearest();
  return t;
}
/// Whether they meet at a fraction of the step, without polynomials in time: all points are moved
/// there, and asked at rest.
bool meet_at(const Four& four, bool edges, const Rational& t) {
  Four there = four;
  for (std::size_t k = 0; k < 4; ++k) {
    there.start[k] = four.start[k] + four.displacement[k] * t;
    there.displacement[k] = oracle::Vector(0, 0, 0);
  }
  return first(there, edges).has_value();
}

template <class Check>
void each_family(int wanted, Check check) {
  generators::Random random(31);
  for (const bool edges : {false, true}) {
    for (const families::Points family : families::all_points) {
      for (int i = 0; i < generators::tried(wanted); ++i) {
        CAPTURE(families::name(family), edges, i);
        check(four_of(families::points(random, family, edges)), edges);
      }
    }
  }
}

}  // namespace

TEST_CASE("moving truth: no sampled meeting is before the first time") {
  each_family(6, [](const Four& four, bool edges) {
    const auto t = first(four, edges);
    for (int k = 0; k <= 8; ++k) {
      const Rational at = Rational(k) / 8;
      if (!meet_at(four, edges, at)) continue;
      REQUIRE(t);
      CHECK(t->low() <= at);
    }
  });
}

TEST_CASE("moving truth: a first time that is a fraction is a meeting") {
  each_family(8, [](const Four& four, bool edges) {
    const auto t = first(four, edges);
    if (t && t->low() == t->high()) CHECK(meet_at(four, edges, t->low()));
  });
}

TEST_CASE("moving truth: the reverse motion meets as well, not before the mirrored time") {
  each_family(6, [](const Four& four, bool edges) {
    Four reverse = four;
    for (std::size_t k = 0; k < 4; ++k) {
      reverse.start[k] = four.start[k] + four.displacement[k];
      reverse.displacement[k] = -four.displacement[k];
    }
    const auto forth = first(four, edges), back = first(reverse, edges);
    REQUIRE(forth.has_value() == back.has_value());
    // The last meeting is not before the first.
    if (forth) CHECK(Rational(1) - back->low() >= forth->low());
  });
}

TEST_CASE("moving truth: a common displacement changes nothing") {
  each_family(4, [](const Four& four, bool edges) {
    Four moved = four;
    for (std::size_t k = 0; k < 4; ++k) {
      moved.start[k] = four.start[k] + oracle::Vector(5, -3, Rational(1) / 3);
      moved.displacement[k] = four.displacement[k] + oracle::Vector(-7, Rational(2) / 7, 11);
    }
    const auto here = first(four, edges), there = first(moved, edges);
    REQUIRE(here.has_value() == there.has_value());
    if (here) {
      CHECK(here->low() == there->low());
      CHECK(here->high() == there->high());
    }
  });
}

TEST_CASE("moving truth: aimed at a time, they meet by then") {
  generators::Random random(32);
  for (const bool edges : {false, true}) {
    for (const auto family : {families::Points::at_the_start, families::Points::at_the_end,
                              families::Points::on_the_rim, families::Points::fast}) {
      for (int i = 0; i < generators::tried(30); ++i)
        CHECK(first(four_of(families::points(random, family, edges)), edges));
    }
  }
}

TEST_CASE("moving truth: a double root is one meeting, a last bit decides") {
  // The height of one edge over the other is 2 (t − 1/2)² + gap.
  const auto turning_over = [](const Rational& gap) {
    const Rational half = Rational(1) / 2;
    const Rational height = half - gap;
    Four four;
    four.start = {oracle::Vector(-1, 0, 1), oracle::Vector(1, 0, 0), oracle::Vector(-1, -1, height),
                  oracle::Vector(-1, 1, height)};
    four.displacement = {oracle::Vector(0, 0, -1), oracle::Vector(0, 0, 1), oracle::Vector(2, 0, 0),
                         oracle::Vector(2, 0, 0)};
    return first(four, true);
  };
  const Rational bit = oracle::exact(0x1p-200);
  const auto touch = turning_over(0);
  REQUIRE(touch);
  CHECK(touch->low() == Rational(1) / 2);
  CHECK(touch->high() == Rational(1) / 2);
  CHECK_FALSE(turning_over(bit));
  CHECK(turning_over(-bit));
}

}  // namespace moving_truth_test
