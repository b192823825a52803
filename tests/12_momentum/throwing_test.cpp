// Right answers are quotients of exact numbers, rounded once. Every test asks for at least two
// different answers, so that no constant passes one.
#include "throwing.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

#include <contact/exact.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using Stones = std::vector<double>;

void check_exchange(double mass, double velocity, double change, double matter) {
  const Exact left = Exact(mass) + Exact(change);
  const double right =
      quotient<double>(Exact(mass) * Exact(velocity) + Exact(change) * Exact(matter), left);
  // Differences, product, quotient, sum; or two products, a sum and a quotient.
  const double bound =
      8 * 0x1p-53 *
      (mass * std::abs(velocity) + std::abs(change * velocity) + std::abs(change * matter)) /
      (mass + change);
  ask("What is the body's velocity after the matter has joined or left it?")
      .given("mass", mass)
      .given("velocity", velocity)
      .given("mass_change", change)
      .given("matter_velocity", matter)
      .suspect("momentum-of-body-alone", [&] { return mass * velocity / (mass + change); })
      .suspect("relative-for-ground", [&] { return velocity + matter * change / (mass + change); })
      .answer([&] { return exercise::after_exchange(mass, velocity, change, matter); })
      .close_to(right, within(bound));
}

double whole_of(double thrower, const Stones& stones) {
  double whole = thrower;
  for (const double stone : stones) whole += stone;
  return whole;
}

void check_throws(double thrower, const Stones& stones, double velocity, double relative) {
  // v − u Σ s/M as one fraction.
  Exact whole(thrower);
  for (const double stone : stones) whole += Exact(stone);
  Exact numerator;
  Exact denominator(1.0);
  double size = std::abs(velocity);
  double rounded_whole = whole_of(thrower, stones);
  for (const double stone : stones) {
    numerator = numerator * whole + Exact(stone) * denominator;
    denominator *= whole;
    size += std::abs(relative) * stone / rounded_whole;
    whole -= Exact(stone);
    rounded_whole -= stone;
  }
  const double right =
      quotient<double>(Exact(velocity) * denominator - Exact(relative) * numerator, denominator);
  const double n = static_cast<double>(stones.size());
  // The remaining mass may be computed as the total minus the thrown mass: its error is n u of the
  // total, that is n u total/thrower of itself.
  const double bound = (2 * n + 8) * 0x1p-53 * size * whole_of(thrower, stones) / thrower;
  ask("What is the thrower's velocity after the last throw?")
      .given("thrower", thrower)
      .given("stones", stones)
      .given("velocity", velocity)
      .given("relative", relative)
      .suspect("recoil-forwards", [&] { return 2 * velocity - right; })
      .suspect("relative-to-before",
               [&] {
                 double mass = whole_of(thrower, stones);
                 double v = velocity;
                 for (const double stone : stones) {
                   mass -= stone;
                   v -= relative * stone / mass;
                 }
                 return v;
               })
      .suspect("relative-for-ground",
               [&] {
                 double mass = whole_of(thrower, stones);
                 double v = velocity;
                 for (const double stone : stones) {
                   v = (mass * v - stone * relative) / (mass - stone);
                   mass -= stone;
                 }
                 return v;
               })
      .suspect("thrown-at-once",
               [&] {
                 const double mass = whole_of(thrower, stones);
                 return velocity - relative * (mass - thrower) / mass;
               })
      .suspect("carried-mass-forgotten",
               [&] {
                 double v = velocity;
                 for (const double stone : stones) v -= relative * stone / (thrower + stone);
                 return v;
               })
      .answer([&] { return exercise::after_throws(thrower, stones, velocity, relative); })
      .close_to(right, within(bound));
}

}  // namespace

TEST_CASE("rain slows a wagon and sand that runs out does not") {
  check_exchange(4000, 3, -1000, 3);
  check_exchange(4000, 5, -2500, 5);
  check_exchange(4000, 3, 2000, 0);
}

TEST_CASE("matter with a relative velocity causes thrust") {
  check_exchange(4, 0, -1, 6);
  check_exchange(4, 2, -1, -4);
  check_exchange(3, 2, 1, 10);
}

TEST_CASE("a throw pushes the thrower in the opposite direction") {
  check_throws(60, {4}, 2, 8);
  check_throws(60, {4}, 0, 8);
  check_throws(60, {4}, 0, -8);
  check_throws(60, {}, 0, 8);
}

TEST_CASE("each throw starts from a smaller mass") {
  check_throws(2, {1, 1}, 0, 12);
  check_throws(60, {20, 10, 6}, 0, 8);
  check_throws(60, {6, 10, 20}, 0, 8);
}

TEST_CASE("the thrower's own velocity is added") {
  check_throws(60, {4}, 2, 8);
  check_throws(60, {4}, -1, 8);
  check_throws(8, {4, 4}, 3, -6);
}

TEST_CASE("random throws agree with exact arithmetic") {
  generators::Random random(seed(0));
  for (int asked = 0; asked < 300; ++asked) {
    const double mass = random.uniform(1, 9);
    const double velocity = random.uniform(-9, 9);
    const double change = random.uniform(-0.9, 2) * mass;
    check_exchange(mass, velocity, change, random.uniform(-9, 9));
    Stones stones;
    for (int n = random.integer(1, 5); n > 0; --n) stones.push_back(random.uniform(0.1, 3));
    check_throws(mass, stones, velocity, random.uniform(-9, 9));
  }
}
