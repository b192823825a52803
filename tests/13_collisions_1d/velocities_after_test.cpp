// Right answers are quotients of exact numbers, rounded once. Every test asks for at least two
// different answers, so that no constant passes one.
#include "velocities_after.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <contact/exact.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using exercise::After;
using exercise::Body;

After with_bounce(const Body& a, const Body& b, double e) {
  const double change = (1 + e) * (a.velocity - b.velocity);
  const double mass = a.mass + b.mass;
  return {a.velocity - change * b.mass / mass, b.velocity + change * a.mass / mass};
}

After right_answer(const Body& a, const Body& b, double e) {
  if (a.velocity <= b.velocity) return {a.velocity, b.velocity};
  const Exact m1(a.mass);
  const Exact m2(b.mass);
  const Exact v1(a.velocity);
  const Exact v2(b.velocity);
  const Exact k(e);
  const Exact one(1.0);
  return {quotient<double>((m1 - k * m2) * v1 + (one + k) * m2 * v2, m1 + m2),
          quotient<double>((m2 - k * m1) * v2 + (one + k) * m1 * v1, m1 + m2)};
}

void check(const Body& first, const Body& second, double restitution) {
  // In every form there are at most 8 roundings, of terms that are at most 2 (|v₁| + |v₂|).
  const double bound = 16 * 0x1p-53 * (std::abs(first.velocity) + std::abs(second.velocity));
  ask("What are the velocities after the collision?")
      .given("first", first)
      .given("second", second)
      .given("restitution", restitution)
      .suspect("no-approach-test", [&] { return with_bounce(first, second, restitution); })
      .suspect("restitution-scales-energy",
               [&] { return with_bounce(first, second, std::sqrt(restitution)); })
      .suspect("updated-too-early",
               [&] {
                 const double v1 = with_bounce(first, second, restitution).first;
                 const double v2 = with_bounce({first.mass, v1}, second, restitution).second;
                 return After{v1, v2};
               })
      .suspect("updated-too-early",
               [&] {
                 const double v2 = with_bounce(first, second, restitution).second;
                 const double v1 = with_bounce(first, {second.mass, v2}, restitution).first;
                 return After{v1, v2};
               })
      .suspect("restitution-of-each-body",
               [&] {
                 return After{-restitution * first.velocity, -restitution * second.velocity};
               })
      .suspect_if("separates-at-a-wrong-speed",
                  [&](const After& got) {
                    const double closing = first.velocity - second.velocity;
                    const double separation = got.second - got.first;
                    const double gained = first.mass * (got.first - first.velocity) +
                                          second.mass * (got.second - second.velocity);
                    // With √e it is another mistake.
                    return closing > 0 && std::abs(gained) <= bound * (first.mass + second.mass) &&
                           std::abs(separation - restitution * closing) > 4 * bound &&
                           std::abs(separation - std::sqrt(restitution) * closing) > 4 * bound;
                  })
      .suspect("own-share-of-mass",
               [&] {
                 return with_bounce({second.mass, first.velocity}, {first.mass, second.velocity},
                                    restitution);
               })
      .answer([&] { return exercise::collide(first, second, restitution); })
      .close_to(right_answer(first, second, restitution), within(bound));
}

void check_refused(const Body& first, const Body& second, double restitution) {
  ask("What are the velocities after the collision?")
      .given("first", first)
      .given("second", second)
      .given("restitution", restitution)
      .suspect_if("restitution-not-refused",
                  [restitution](const After&) { return restitution < 0 || restitution > 1; })
      .suspect_if("restitution-nan-accepted",
                  [restitution](const After&) { return std::isnan(restitution); })
      .suspect_if("mass-not-refused",
                  [&](const After&) { return !(first.mass > 0 && second.mass > 0); })
      .answer([&] { return exercise::collide(first, second, restitution); })
      .throws_invalid_argument();
}

}  // namespace

TEST_CASE("equal bodies exchange their velocities") {
  check({1, 5}, {1, 0}, 1);
  check({2, 3}, {2, -4}, 1);
  check({7, -1}, {7, -8}, 1);
}

TEST_CASE("with e = 0 both leave at one velocity") {
  check({3000, 20}, {1000, 0}, 0);
  check({90, 6}, {80, -7}, 0);
  check({1, 1}, {3, -3}, 0);
}

TEST_CASE("the changes of velocity are inversely proportional to the masses") {
  check({3000, 20}, {1000, 0}, 1);
  check({1, 20}, {1023, 0}, 1);
  check({1023, 20}, {1, -20}, 1);
}

TEST_CASE("the speed of separation is e times the closing speed") {
  check({1, 4}, {1, 0}, 0.5);
  check({3, 8}, {1, 0}, 0.25);
  check({1, 8}, {3, -8}, 0.75);
}

TEST_CASE("bodies that do not approach keep their velocities") {
  check({1, 2}, {3, 5}, 1);
  check({2, -4}, {1, 4}, 0.5);
  check({2, 3}, {5, 3}, 0);
  check({2, 5}, {1, -4}, 0.5);
}

TEST_CASE("invalid masses and coefficients are refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  check({1, 2}, {3, -5}, 1);
  check({1, 2}, {3, -5}, 0);
  check_refused({0, 2}, {3, -5}, 1);
  check_refused({1, 2}, {-3, -5}, 0.5);
  check_refused({1, 2}, {0, -5}, 0.5);
  check_refused({nan, 2}, {3, -5}, 0.5);
  check_refused({1, 2}, {3, -5}, 1.5);
  check_refused({1, 2}, {3, -5}, -0.25);
  check_refused({1, 2}, {3, -5}, nan);
}

TEST_CASE("random collisions agree with exact arithmetic") {
  generators::Random random(seed(0));
  const auto possible = [](const Body& first, const Body& second, double restitution) {
    return first.mass > 0 && second.mass > 0 && restitution >= 0 && restitution <= 1;
  };
  for (int asked = 0; asked < 300; ++asked) {
    const Body first{random.uniform(0.1, 9), random.uniform(-9, 9)};
    const Body second{random.uniform(0.1, 9), random.uniform(-9, 9)};
    shrinkable(check, possible, first, second, random.uniform());
  }
}
