// rollback.hpp: brackets of an impact, and rolling back to their free end.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/bouncing.hpp>
#include <contact/rollback.hpp>
#include <limits>

#include "support/generators.hpp"
#include "support/oracle.hpp"

using generators::Random;
using oracle::Rational;

TEST_CASE("brackets are free at one end and blocked at the other, down to neighbouring numbers") {
  Random random(1914);
  for (int i = 0; i < 1000; ++i) {
    const double wall = random.uniform(0.01, 0.99);
    int asked = 0;
    const auto is_free = [&](double t) {
      ++asked;
      return t < wall;
    };
    const int slices = random.integer(1, 20);
    const auto slice = contact::last_free_slice(is_free, 1.0, slices);
    REQUIRE(slice);
    REQUIRE(slice->free < wall);
    REQUIRE(slice->blocked >= wall);
    REQUIRE(slice->blocked - slice->free <= (1 + 1e-12) / slices);
    const double width = random.chance(0.3) ? 0 : std::ldexp(1.0, -random.integer(5, 40));
    const auto bracket = contact::bisected(is_free, *slice, width);
    REQUIRE(bracket.free < wall);
    REQUIRE(bracket.blocked >= wall);
    REQUIRE(bracket.tests == asked);
    if (width > 0) {
      REQUIRE(bracket.blocked - bracket.free <= width);
    } else {
      REQUIRE(bracket.blocked == std::nextafter(bracket.free, 1.0));
      REQUIRE(bracket.blocked == wall);
    }
  }
}

TEST_CASE("an overlap that begins and ends between two tests is missed") {
  const auto is_free = [](const Rational& t) {
    return t < Rational(4) / 10 || t > Rational(6) / 10;
  };
  CHECK_FALSE(contact::last_free_slice<Rational>(is_free, 1, 1));
  CHECK_FALSE(contact::last_free_slice<Rational>(is_free, 1, 3));
  const auto seen = contact::last_free_slice<Rational>(is_free, 1, 5);
  REQUIRE(seen);
  CHECK(seen->free == Rational(1) / 5);
  CHECK(seen->blocked == Rational(2) / 5);
}

TEST_CASE("rolling back gains no energy, never passes the floor, and converges") {
  Random random(1915);
  for (int i = 0; i < 200; ++i) {
    const double height = random.uniform(0.5, 3);
    const double k = random.chance(0.5) ? 1 : random.uniform(0.5, 0.9);
    const auto ball = contact::bouncing_ball(height, 0.0, 9.81, k);
    const double dt = random.uniform(0.005, 0.03);
    const int steps = static_cast<int>(1.5 / dt);
    contact::BounceState<double> coarse{height, 0, 0, false};
    contact::BounceState<double> fine = coarse;
    double energy = 9.81 * height;
    for (int step = 0; step < steps; ++step) {
      coarse = contact::rolled_back_step<double>(coarse, ball, dt,
                                                 {4, std::numeric_limits<double>::infinity()});
      fine = contact::rolled_back_step<double>(fine, ball, dt, {1, 0x1p-48});
      REQUIRE(coarse.height >= 0);
      REQUIRE(fine.height >= 0);
      const double now = coarse.velocity * coarse.velocity / 2 + 9.81 * coarse.height;
      REQUIRE(now <= energy + 1e-13 * energy);
      energy = std::min(energy, now);
    }
    const auto truth = contact::bounce_at(ball, dt * steps);
    if (truth.resting || truth.bounces > 6 || truth.height < 1e-6) continue;
    CHECK(fine.bounces == truth.bounces);
    // At most seven impacts, each early by 2^-48 s, at speeds below 8 m/s, with 1.5 s to go.
    CHECK(std::abs(fine.height - truth.height) <= 7 * 8 * 0x1p-48 * 8 + 1e-12);
  }
}
