// How much a hit spreads two paths: the planner's number for the first hits of a scene.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/plan/plan_spreading.hpp>

#include "support/generators.hpp"

namespace {

contact::FirstHit spread_hit(double distance, double radius) {
  contact::FirstHit hit;
  hit.radius = radius;
  hit.distance = distance;
  return hit;
}

}  // namespace

TEST_CASE("the spread of a hit is 4 ε/(R cos θ) for errors as small as an ulp") {
  generators::Random random(4);
  for (int i = 0; i < 2000; ++i) {
    const double radius = std::ldexp(random.uniform(1, 2), random.integer(-20, 20));
    const double distance = radius * random.uniform(0, 0.99);
    const double error = std::ldexp(radius, -random.integer(30, 60));
    const double cosine = std::sqrt((radius - distance) * (radius + distance)) / radius;
    const double right = 4 * error / (radius * cosine);
    const double spread = contact::spread_of_deflection(spread_hit(distance, radius), error);
    CAPTURE(radius, distance, error);
    // The next term is of the size (error/R)²/cos⁴ θ < 2e-15.
    CHECK(std::abs(spread - right) <= 1e-12 * right);
  }
}

TEST_CASE("a graze spreads paths by the root of the error, a miss by more not at all") {
  const double error = 0x1p-52;
  const double graze = contact::spread_of_deflection(spread_hit(1, 1), error);
  // 2 acos(1 − ε) = 4 asin √(ε/2)
  CHECK(std::abs(graze - 4 * std::asin(std::sqrt(error / 2))) <= 1e-15 * graze);
  CHECK(contact::spread_of_deflection(spread_hit(1 + 2 * error, 1), error) == 0);
}
