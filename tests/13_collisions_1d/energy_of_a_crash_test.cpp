// Right answers are quotients of exact numbers, rounded once. Every test asks for at least two
// different answers, so that no constant passes one.
#include "energy_of_a_crash.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

#include <contact/exact.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using exercise::Body;
using exercise::EnergyLoss;

double energy(const Body& a, const Body& b) {
  return 0.5 * (a.mass * a.velocity * a.velocity + b.mass * b.velocity * b.velocity);
}

EnergyLoss right_answer(const Body& a, const Body& b, double e) {
  if (a.velocity <= b.velocity) return {0, 0};
  const Exact m1(a.mass);
  const Exact m2(b.mass);
  const Exact v1(a.velocity);
  const Exact v2(b.velocity);
  const Exact k(e);
  const Exact one(1.0);
  const Exact w = v1 - v2;
  const Exact loss = m1 * m2 * (one - k * k) * w * w;  // times 2 (m₁ + m₂)
  const Exact whole = m1 + m2;
  return {quotient<double>(loss, Exact(2.0) * whole),
          quotient<double>(loss, whole * (m1 * v1 * v1 + m2 * v2 * v2))};
}

void check(const Body& first, const Body& second, double restitution) {
  const EnergyLoss right = right_answer(first, second, restitution);
  const double w = first.velocity - second.velocity;
  const double mu = first.mass * second.mass / (first.mass + second.mass);
  const double before = energy(first, second);
  const double e = restitution;
  // At most 11 roundings for the loss and 6 more for the fraction. The form 1 − e² rounds e² before
  // the subtraction, which magnifies the error by 1/(1 − e²); no e here is above 0.95.
  const double room = (20 + 2 / (1 - e * e)) * 0x1p-53;
  const auto of = [before](double lost) {
    return EnergyLoss{lost, before > 0 ? lost / before : 0};
  };
  ask("What kinetic energy does the collision lose?")
      .given("first", first)
      .given("second", second)
      .given("restitution", restitution)
      .suspect("no-approach-test", [&] { return of(0.5 * mu * (1 - e * e) * w * w); })
      .suspect("fraction-of-everything", [&] { return of((1 - e * e) * before); })
      .suspect("fraction-of-everything",
               [&] {
                 return EnergyLoss{right.lost, right.lost > 0 ? 1 - e * e : 0};
               })
      .suspect("restitution-scales-energy-loss", [&] { return of(0.5 * mu * (1 - e) * w * w); })
      .suspect_if("nothing-lost",
                  [&](const EnergyLoss& got) {
                    // A smaller loss may vanish in a difference of energies.
                    return got.lost == 0 && right.lost > 0x1p-40 * before;
                  })
      .suspect("sum-for-reduced-mass",
               [&] { return of(0.5 * (first.mass + second.mass) * (1 - e * e) * w * w); })
      .suspect_if("energy-by-subtraction",
                  [right, before, room](const EnergyLoss& got) {
                    const double off = std::abs(got.lost - right.lost);
                    if (!(off > room * right.lost && off <= 0x1p-46 * before)) return false;
                    // A difference of two energies is a multiple of a digit of theirs. This digit
                    // is far below their last one, and far above those of the loss.
                    return std::fmod(got.lost, std::ldexp(1.0, std::ilogb(before) - 64)) == 0;
                  })
      .answer([&] { return exercise::energy_loss(first, second, restitution); })
      .close_to(right, within(EnergyLoss{room * right.lost, room * right.fraction}));
}

}  // namespace

TEST_CASE("the truck and the parked car") {
  check({3000, 20}, {1000, 0}, 0);
  check({1000, 20}, {3000, 0}, 0);
  check({3000, 20}, {1000, -20}, 0);
}

TEST_CASE("in the frame of a train the loss is the same") {
  check({2, 6}, {1, 0}, 0);
  check({2, 3}, {1, -3}, 0);
  check({2, 16}, {1, 10}, 0);
}

TEST_CASE("of the energy of the relative motion the share 1 - e^2 is lost") {
  check({1, 4}, {1, 0}, 0.5);
  check({3, 8}, {1, 0}, 0.25);
  check({3, 8}, {1, -2}, 0.75);
}

TEST_CASE("bodies that do not approach lose nothing") {
  check({2, 3}, {1, 4}, 0.5);
  check({2, -3}, {1, 3}, 0);
  check({2, 3}, {1, 2}, 0.5);
  check({2, 0}, {1, 0}, 0.5);  // at rest: there is no energy to lose
}

TEST_CASE("the loss in docking is accurate at orbital speeds") {
  check({4000, 7000.0625}, {90000, 7000}, 0);
  check({4000, 7000.00390625}, {90000, 7000}, 0.25);
  check({0.5, 1e8 + 0x1p-20}, {2, 1e8}, 0.5);
}

TEST_CASE("random crashes agree with exact arithmetic") {
  generators::Random random(seed(0));
  for (int asked = 0; asked < 300; ++asked) {
    const Body first{random.uniform(0.1, 9), random.uniform(-9, 9)};
    const Body second{random.uniform(0.1, 9), random.uniform(-9, 9)};
    check(first, second, random.uniform(0, 0.95));
  }
}
