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

TEST_CASE("the slices of a step whose multiples overflow end within it") {
  std::vector<double> asked;
  const auto found = contact::sliced_step<double>(
      [&asked](double t) {
        asked.push_back(t);
        return false;
      },
      1e308, 3);
  CHECK_FALSE(found.has_value());
  REQUIRE(asked.size() == 4);
  CHECK(asked[1] == 1e308 / 3);
  CHECK(asked[2] == 1e308 / 3 * 2);
  CHECK(asked[3] == 1e308);
}

TEST_CASE("of two overlaps the slices may miss the first: then the free state is after it") {
  const auto overlap = [](double t) { return (t >= 0.2 && t <= 0.3) || t >= 0.7; };
  const auto state = previous_free_state<double>(overlap, 2);
  CHECK(state.hit);
  CHECK(state.t == 0.5);
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

TEST_CASE("without gravity a body that rises does so in all steps") {
  const auto gaps = gaps_of_previous_free_state<double>({1, 0.5, 0}, 3, 4);
  CHECK(gaps == std::vector<double>{1.5, 2, 2.5, 3});
}

TEST_CASE("a fall whose numbers overflow is refused") {
  using Fall = contact::RestingFall<double>;
  for (const Fall& fall : {Fall{1, -1.7e308, 1.7e308}, Fall{1.7e308, 1e308, 0}, Fall{1, 0, 1e307}})
    CHECK_THROWS_AS(gaps_of_previous_free_state(fall, 1, 40), std::invalid_argument);
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
