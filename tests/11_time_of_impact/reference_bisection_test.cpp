// Bisection: how many halvings a tolerance takes, and the two ends.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/bisection.hpp>
#include <limits>
#include <stdexcept>
#include <vector>

#include "support/generators.hpp"

namespace bisection_test {
namespace {

using contact::bisect_impact;
using contact::halvings_to;
using contact::ImpactBracket;
using generators::Random;

TEST_CASE("halvings: the bracket is within the tolerance, and one fewer is not enough") {
  Random random(31);
  for (int i = 0; i < generators::tried(2000); ++i) {
    const ImpactBracket<double> bracket{0, std::abs(random.magnitude(-40, 40))};
    const double tolerance = std::abs(random.magnitude(-60, 40));
    const int k = halvings_to(bracket, tolerance);
    CHECK(std::ldexp(bracket.hit, -k) <= tolerance);
    if (k > 0) CHECK(std::ldexp(bracket.hit, 1 - k) > tolerance);
  }
  CHECK(halvings_to<double>({2, 2}, 0.5) == 0);
  CHECK(halvings_to<double>({0, 1}, std::numeric_limits<double>::denorm_min()) == 1074);
}

TEST_CASE("halvings of subnormal widths are not rounded") {
  constexpr double least = std::numeric_limits<double>::denorm_min();
  CHECK(halvings_to<double>({0, 5 * least}, 2 * least) == 2);
  CHECK(halvings_to<double>({0, 4 * least}, 2 * least) == 1);
  CHECK(halvings_to<double>({0, std::numeric_limits<double>::max()}, 0x1.8p1023) == 1);
}

TEST_CASE("halvings of an invalid bracket or tolerance are refused") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(halvings_to<double>({1, 0}, 0.5), std::invalid_argument);
  CHECK_THROWS_AS(halvings_to<double>({nan, 0}, 0.5), std::invalid_argument);
  CHECK_THROWS_AS(halvings_to<double>({0, 1}, 0.0), std::invalid_argument);
  CHECK_THROWS_AS(halvings_to<double>({0, 1}, nan), std::invalid_argument);
}

TEST_CASE("the first halvings of a step from 2 to 3 ask at 2.5 and then at 2.25") {
  std::vector<double> asked;
  const auto overlap = [&asked](double t) {
    asked.push_back(t);
    return t >= 2.125;
  };
  const auto bracket = bisect_impact<double>(overlap, {2, 3}, 2);
  CHECK(asked == std::vector<double>{2.5, 2.25});
  CHECK(bracket.free == 2);
  CHECK(bracket.hit == 2.25);
}

TEST_CASE("bisection keeps a free and an overlapping end, and halves the bracket each time") {
  Random random(32);
  for (int i = 0; i < generators::tried(500); ++i) {
    const double impact = random.uniform(0.001, 1);
    const auto overlap = [impact](double t) { return t >= impact; };
    const int halvings = random.integer(0, 30);
    const auto bracket = bisect_impact<double>(overlap, {0, 1}, halvings);
    CHECK(bracket.free < impact);
    CHECK(impact <= bracket.hit);
    CHECK(bracket.hit - bracket.free == std::ldexp(1.0, -halvings));
  }
}

TEST_CASE("where an overlap ends and another begins, bisection may find the second") {
  const auto overlap = [](double t) { return (t >= 0.25 && t <= 0.375) || t >= 0.75; };
  const auto bracket = bisect_impact<double>(overlap, {0, 1}, 60);
  CHECK(bracket.hit == 0.75);
}

}  // namespace
}  // namespace bisection_test
