// Right answers are the formula without rounding, rounded once. Every test asks for at least two
// different answers, so that no constant passes one.
#include "bounce_impulse.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <contact/exact.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using Vector = Eigen::Vector3d;

Vector exact_impulse(double mass, const Vector& before, const Vector& after) {
  const auto coordinate = [&](int k) {
    return quotient<double>(Exact(mass) * (Exact(after(k)) - Exact(before(k))), Exact(1.0));
  };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

void check_impulse(double mass, const Vector& before, const Vector& after) {
  // A difference and a product, or two products and a difference: 3 u of the momenta, plus 1 u of
  // the oracle. Doubled.
  const Vector bound = 8 * 0x1p-53 * mass * (before.cwiseAbs() + after.cwiseAbs());
  ask("What impulse changes the velocity from before to after?")
      .given("mass", mass)
      .given("before", before)
      .given("after", after)
      .suspect("change-reversed", [&]() -> Vector { return mass * (before - after); })
      .suspect("momentum-after-only", [&]() -> Vector { return mass * after; })
      .suspect(
          "speeds-for-velocities",
          [&]() -> Vector { return mass * (after.norm() - before.norm()) * before.normalized(); })
      .suspect("speeds-for-velocities",
               [&]() -> Vector { return mass * (after.cwiseAbs() - before.cwiseAbs()); })
      .answer([&] { return exercise::impulse_of(mass, before, after); })
      .close_to(exact_impulse(mass, before, after), within(bound));
}

void check_force(const Vector& impulse, double duration) {
  const auto coordinate = [&](int k) {
    return quotient<double>(Exact(impulse(k)), Exact(duration));
  };
  const Vector right{coordinate(0), coordinate(1), coordinate(2)};
  ask("What average force gives this impulse in this time?")
      .given("impulse", impulse)
      .given("duration", duration)
      .suspect("force-times-for-force-over", [&]() -> Vector { return impulse * duration; })
      .answer([&] { return exercise::average_force(impulse, duration); })
      .close_to(right, within(Vector(4 * 0x1p-53 * right.cwiseAbs())));
}

}  // namespace

TEST_CASE("a stop takes all the momentum away") {
  check_impulse(0.5, {8, 4, -2}, {0, 0, 0});
  check_impulse(2, {-3, 0, 0}, {0, 0, 0});
}

TEST_CASE("a bounce takes more than a stop") {
  check_impulse(2, {-3, 0, 0}, {3, 0, 0});
  check_impulse(2, {-3, 0, 0}, {2, 0, 0});
  check_impulse(0.25, {0, 4, -16}, {0, 4, 12});
}

TEST_CASE("a sideways impulse changes the direction") {
  check_impulse(4, {3, 4, 0}, {4, 3, 0});
  check_impulse(4, {5, 0, 0}, {0, 0, 5});
}

TEST_CASE("a longer time makes a smaller force") {
  check_force({6, 0, 0}, 0.5);
  check_force({6, 0, 0}, 4);
  check_force({-2, 8, 1}, 0.125);
}

TEST_CASE("random changes agree with exact arithmetic") {
  generators::Random random(seed(0));
  const auto vector = [&] {
    return Vector{random.uniform(-20, 20), random.uniform(-20, 20), random.uniform(-20, 20)};
  };
  for (int asked = 0; asked < 300; ++asked) {
    const double mass = random.uniform(0.1, 9);
    const Vector before = vector();
    shrinkable(
        check_impulse, [](double m, const Vector&, const Vector&) { return m > 0; }, mass, before,
        vector());
    const Vector impulse = vector();
    shrinkable(
        check_force, [](const Vector&, double duration) { return duration > 0; }, impulse,
        random.uniform(0.01, 5));
  }
}
