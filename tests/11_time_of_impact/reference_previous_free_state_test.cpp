// The previous free state: never an overlap, at most a slice too early, and a body that rests in
// the air.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/previous_free_state.hpp>
#include <limits>
#include <stdexcept>
#include <vector>

#include "support/generators.hpp"

namespace previous_free_state_test {
namespace {

using contact::gaps_of_previous_free_state;
using contact::previous_free_state;
using generators::Random;

TEST_CASE("a step of 1 in 3 slices is tested at 0, a third, two thirds and 1") {
  std::vector<double> asked;
  const auto state = previous_free_state<double>(
      [&asked](double t) {
        asked.push_back(t);
        return t > 0.9;
      },
      3);
  CHECK(asked == std::vector<double>{0, 1.0 / 3, 2.0 / 3, 1});
  CHECK(state.hit);
  CHECK(state.t == 2.0 / 3);
}

TEST_CASE("the previous free state is free and at most a slice before the overlap") {
  Random random(41);
  for (int i = 0; i < generators::tried(1000); ++i) {
    const double impact = random.uniform(0.001, 1);
    const int slices = random.integer(1, 50);
    const auto state =
        previous_free_state<double>([impact](double t) { return t >= impact; }, slices);
    CHECK(state.hit);
    CHECK(state.t < impact);
    CHECK(impact - state.t <= 1.0 / slices + 0x1p-52);
  }
}

TEST_CASE("without an overlap the state is the end of the step, with one at the start it is 0") {
  const auto free = previous_free_state<double>([](double) { return false; }, 4);
  CHECK_FALSE(free.hit);
  CHECK(free.t == 1);
  const auto inside = previous_free_state<double>([](double) { return true; }, 4);
  CHECK(inside.hit);
  CHECK(inside.t == 0);
}

TEST_CASE("a body put back to the previous free state comes to rest above the floor for good") {
  Random random(42);
  for (int i = 0; i < generators::tried(500); ++i) {
    const double gravity = random.uniform(0.01, 1);
    const int slices = random.integer(1, 10);
    const double gap = random.uniform(0.001, 5);
    const auto gaps = gaps_of_previous_free_state<double>({gap, 0, gravity}, slices, 40);
    REQUIRE(gaps.size() == 40);
    CHECK(std::is_sorted(gaps.rbegin(), gaps.rend()));  // it never rises
    CHECK(gaps.back() > 0);
    CHECK(gaps[38] == gaps[39]);  // and stays
    CHECK(gaps.back() <= gravity / slices * (1 + 0x1p-40));
  }
}

TEST_CASE("a body that is put back rests at a gap that no later step closes") {
  // It falls 1/4 in the first step and 1/2 in the second: 1/8 above the floor it is put back.
  const auto gaps = gaps_of_previous_free_state<double>({0.375, 0, 0.25}, 1, 6);
  CHECK(gaps == std::vector<double>{0.125, 0.125, 0.125, 0.125, 0.125, 0.125});
}

TEST_CASE("an invalid fall is refused") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(gaps_of_previous_free_state<double>({0, 0, 1}, 1, 1), std::invalid_argument);
  CHECK_THROWS_AS(gaps_of_previous_free_state<double>({1, nan, 1}, 1, 1), std::invalid_argument);
  CHECK_THROWS_AS(gaps_of_previous_free_state<double>({1, 0, -1}, 1, 1), std::invalid_argument);
  CHECK_THROWS_AS(gaps_of_previous_free_state<double>({1, 0, 1}, 0, 1), std::invalid_argument);
  CHECK_THROWS_AS(gaps_of_previous_free_state<double>({1, 0, 1}, 1, 0), std::invalid_argument);
}

}  // namespace
}  // namespace previous_free_state_test
