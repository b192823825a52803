// Steps are computed in exact arithmetic and rounded once. The limit is the double next to which
// the quadratic polynomial, evaluated exactly, changes its sign. The first questions of a test each
// bring one mistake to light that no question before did.
#include "largest_step.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <contact/exact.hpp>

#include <16_penalty/step_with_mistakes.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using exercise::State;
using step_with_mistakes::LimitWay;
using step_with_mistakes::Way;

// ---------------------------------------------------------------- what is right

State right_step(const State& now, double k, double c, double m, double h) {
  const Exact mass(m), step(h), d(now.penetration), v(now.approach);
  const Exact approach = v * mass - step * (Exact(k) * d + Exact(c) * v);  // times the mass
  return {quotient<double>(d * mass + step * approach, mass), quotient<double>(approach, mass)};
}

/// The sign of h² k + 2 h c − 4 m: positive beyond the limit.
int beyond(double k, double c, double m, double h) {
  const Exact step(h);
  return (step * step * Exact(k) + Exact(2.0) * step * Exact(c) - Exact(4.0) * Exact(m)).sign();
}

/// The largest double that is not beyond the limit. The polynomial grows with h, so bisection
/// between a number that is not beyond it and one that is finds it.
double right_limit(double k, double c, double m) {
  const double guess = 4 * m / (c + std::sqrt(c * c + 4 * k * m));
  double low = guess * (1 - 0x1p-48), high = guess * (1 + 0x1p-48);
  REQUIRE(beyond(k, c, m, low) <= 0);
  REQUIRE(beyond(k, c, m, high) > 0);
  for (;;) {
    const double middle = low + (high - low) / 2;
    if (!(middle > low && middle < high)) return low;
    (beyond(k, c, m, middle) > 0 ? high : low) = middle;
  }
}

// ---------------------------------------------------------------- questions

void check_step(const State& now, double stiffness, double damping, double mass, double step) {
  const double force = stiffness * now.penetration + damping * now.approach;
  std::vector<Suspect<State>> suspects;
  const auto suspect = [&](std::string_view id, Way way, bool where) {
    if (!where) return;
    suspects.push_back({id, [&, way] {
                          return step_with_mistakes::after_step(now, stiffness, damping, mass, step,
                                                                way);
                        }});
  };
  suspect("penetration-with-the-old-velocity", Way::old_velocity, true);
  suspect("penetration-changed-first", Way::position_first, true);
  suspect("step-without-the-damper", Way::no_damper, damping > 0);
  suspect("damper-drives-the-body", Way::damper_drives, damping > 0);
  suspect("spring-drives-the-body", Way::spring_drives, true);
  suspect("force-for-acceleration", Way::no_mass, mass != 1);
  suspect("damper-of-the-new-velocity", Way::new_damper, damping > 0);
  suspect("force-of-the-new-state", Way::all_new, true);
  suspect("attached-body-let-go", Way::lets_go, force < 0);
  suspect("attached-body-across-a-gap", Way::only_contact, now.penetration < 0);
  // Ten roundings at most of numbers that are smaller than the sums of magnitudes.
  const double speed =
      std::abs(now.approach) +
      step / mass * (stiffness * std::abs(now.penetration) + damping * std::abs(now.approach));
  const State bound{16 * 0x1p-53 * (std::abs(now.penetration) + step * speed),
                    16 * 0x1p-53 * speed};
  ask("Where is the body after the step, and how does it move?")
      .given("now", now)
      .given("stiffness", stiffness)
      .given("damping", damping)
      .given("mass", mass)
      .given("step", step)
      .suspects(std::move(suspects))
      .answer([&] { return exercise::after_step(now, stiffness, damping, mass, step); })
      .close_to(right_step(now, stiffness, damping, mass, step), within(bound));
}

void check_limit(double stiffness, double damping, double mass) {
  std::vector<Suspect<double>> suspects;
  const auto suspect = [&](std::string_view id, LimitWay way, bool where) {
    if (!where) return;
    suspects.push_back(
        {id, [&, way] { return step_with_mistakes::limit(stiffness, damping, mass, way); }});
  };
  const bool damped = damping > 0;
  suspect("limit-without-the-damper", LimitWay::undamped, damped);
  suspect("half-of-the-limit", LimitWay::half, true);
  suspect("frequency-for-a-time", LimitWay::frequency, !damped);
  suspect("limit-of-explicit-euler", LimitWay::explicit_euler, true);
  suspect("limit-of-an-implicit-damper", LimitWay::new_damper, damped);
  suspect("period-for-the-limit", LimitWay::period, !damped);
  suspect("limit-of-the-damper-alone", LimitWay::damper_alone, true);
  suspect("smaller-of-two-limits", LimitWay::smaller, damped);
  suspect("limit-by-a-difference", LimitWay::difference, damped);
  suspect("damper-counted-once", LimitWay::energy, damped);
  const bool oscillates = damping * damping < 4 * stiffness * mass;
  suspects.push_back(
      {"root-of-a-negative-number", std::function<bool(const double&)>([=](const double& got) {
         return oscillates && std::isnan(got);
       })});
  const double right = right_limit(stiffness, damping, mass);
  // Seven roundings; a difference in place of the sum loses what the root exceeds the damping by,
  // which is more than this in the test of strong damping alone.
  ask("Up to which step is the motion stable?")
      .given("stiffness", stiffness)
      .given("damping", damping)
      .given("mass", mass)
      .suspects(std::move(suspects))
      .answer([&] { return exercise::largest_step(stiffness, damping, mass); })
      .close_to(right, within(1e-11 * right));
}

bool is_contact(double stiffness, double damping, double mass) {
  return stiffness >= 0.001 && mass >= 0.001 && damping >= 0 && stiffness <= 1e6 && mass <= 1e6 &&
         damping <= 1e6;
}

bool is_step(const State& now, double stiffness, double damping, double mass, double step) {
  return is_contact(stiffness, damping, mass) && step >= 0.001 && step <= 10 &&
         std::abs(now.penetration) <= 100 && std::abs(now.approach) <= 100;
}

}  // namespace

TEST_CASE("a spring without a damper takes a step") {
  check_step({3, 2}, 4, 0, 8, 0.5);
  check_step({0, 5}, 4, 0, 8, 0.5);
  check_step({1, -3}, 16, 0, 2, 0.25);
}

TEST_CASE("the damper acts with the velocity of the start") {
  check_step({3, 2}, 4, 6, 8, 0.5);
  check_step({0, 5}, 4, 2, 8, 0.5);
  check_step({0.5, -3}, 16, 2, 2, 0.25);
}

TEST_CASE("an attached body is pulled too") {
  check_step({1, -2}, 4, 6, 8, 0.5);
  check_step({-1, 3}, 4, 6, 8, 0.5);
  check_step({-1, -3}, 4, 0, 8, 0.5);
}

TEST_CASE("without a damper the limit is two over the frequency") {
  check_limit(4, 0, 9);
  check_limit(100, 0, 0.25);
  check_limit(0.125, 0, 50);
}

TEST_CASE("a damper makes the limit shorter") {
  check_limit(4, 16, 9);
  check_limit(4, 5, 9);
  check_limit(100, 0.5, 0.25);
  check_limit(2, 40, 3);
}

TEST_CASE("strong damping does not cancel the limit") {
  check_limit(1, 1e6, 1);
  check_limit(1e-3, 1e4, 1e-3);
  check_limit(3, 2e5, 0.5);
}

TEST_CASE("random contacts agree with exact arithmetic") {
  generators::Random random(seed(0));
  for (int asked = 0; asked < 200; ++asked) {
    const double stiffness = random.uniform(1, 1000), mass = random.uniform(0.1, 20);
    const double damping = random.chance(0.25) ? 0 : random.uniform(0, 30);
    const State now{random.uniform(-2, 2), random.uniform(-5, 5)};
    const double step = random.uniform(0.01, 1);
    shrinkable(check_step, is_step, now, stiffness, damping, mass, step);
    shrinkable(check_limit, is_contact, stiffness, damping, mass);
  }
}
