// The stiffness is computed in exact arithmetic and rounded once. The duration of the contact is
// the reference's, whose arc is a series and not an arc tangent. The first questions of a test each
// bring one mistake to light that no question before did.
#include "stiffness_for_overlap.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <contact/exact.hpp>
#include <contact/trampoline.hpp>

#include <16_penalty/overlap_with_mistakes.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using overlap_with_mistakes::StepWay;
using overlap_with_mistakes::Way;

void check_stiffness(double mass, double height, double gravity, double overlap) {
  std::vector<Suspect<double>> suspects;
  const auto suspect = [&](std::string_view id, Way way, bool where) {
    if (!where) return;
    suspects.push_back({id, [&, way] {
                          return overlap_with_mistakes::stiffness(mass, height, gravity, overlap,
                                                                  way);
                        }});
  };
  const bool falls = height > 0;
  suspect("no-work-during-the-contact", Way::fall_alone, true);
  suspect("energy-of-the-spring-doubled", Way::no_half, true);
  suspect("overlap-at-rest", Way::weight_alone, falls);
  suspect("height-left-out", Way::twice_weight, falls);
  suspect("overlaps-added", Way::weight_once, falls);
  suspect("overlap-not-squared", Way::not_squared, true);
  suspect("fall-shorter-by-the-overlap", Way::from_the_top, true);
  suspect("stiffness-per-mass", Way::no_mass, mass != 1);
  suspect("speed-not-squared", Way::speed_once, falls);
  const Exact d(overlap);
  const double right =
      quotient<double>(Exact(2.0) * Exact(mass) * Exact(gravity) * (Exact(height) + d), d * d);
  // Ten roundings.
  ask("How stiff must the contact be?")
      .given("mass", mass)
      .given("height", height)
      .given("gravity", gravity)
      .given("overlap", overlap)
      .suspects(std::move(suspects))
      .answer([&] { return exercise::stiffness_for_overlap(mass, height, gravity, overlap); })
      .close_to(right, within(32 * 0x1p-53 * right));
}

void check_step(double mass, double height, double gravity, double stiffness, int steps) {
  std::vector<Suspect<double>> suspects;
  const auto suspect = [&](std::string_view id, StepWay way, bool where) {
    if (!where) return;
    suspects.push_back({id, [&, way] {
                          return overlap_with_mistakes::step(mass, height, gravity, stiffness,
                                                             steps, way);
                        }});
  };
  const bool falls = height > 0;
  suspect("contact-without-gravity", StepWay::half_period, true);
  suspect("whole-period-for-the-contact", StepWay::whole_period, falls);
  suspect("contact-up-to-the-depth", StepWay::to_the_depth, true);
  suspect("rest-of-the-period", StepWay::above_rest, true);
  suspect("cycles-for-radians", StepWay::cycles, true);
  suspect("inverse-of-the-frequency", StepWay::exchanged, true);
  suspect("square-for-the-speed", StepWay::no_root, falls);
  suspect("contact-not-divided", StepWay::not_divided, steps > 1);
  suspect("points-for-steps", StepWay::one_more, steps > 1);
  suspect("one-step-more", StepWay::one_less, true);
  const double right =
      contact::trampoline_jump(contact::Trampoline<double>{mass, stiffness, gravity, height})
          .contact_time /
      steps;
  // The reference is within 40 u, and other formulas lose a few digits where β is near π / 2.
  ask("How long is the step?")
      .given("mass", mass)
      .given("height", height)
      .given("gravity", gravity)
      .given("stiffness", stiffness)
      .given("steps", steps)
      .suspects(std::move(suspects))
      .answer([&] { return exercise::step_for_contact(mass, height, gravity, stiffness, steps); })
      .close_to(right, within(1e-12 * right));
}

bool is_fall(double mass, double height, double gravity, double overlap) {
  return mass >= 0.01 && mass <= 1e4 && height >= 0 && height <= 1e4 && gravity >= 0.01 &&
         gravity <= 1e3 && overlap >= 1e-4 && overlap <= 1e3;
}

bool is_contact(double mass, double height, double gravity, double stiffness, int steps) {
  return mass >= 0.01 && mass <= 1e4 && height >= 0.001 && height <= 1e4 && gravity >= 0.01 &&
         gravity <= 1e3 && stiffness >= 1e-4 && stiffness <= 1e8 && steps >= 1 && steps <= 1000;
}

}  // namespace

TEST_CASE("the spring takes the energy of the whole fall") {
  check_stiffness(3, 2, 10, 0.25);
  check_stiffness(0.5, 0.25, 9.75, 0.125);
  check_stiffness(80, 1, 9.81, 0.01);
}

TEST_CASE("a body that is released at the surface overlaps too") {
  check_stiffness(3, 0, 10, 0.5);
  check_stiffness(0.25, 0, 9.81, 0.01);
  check_stiffness(3, 0.5, 10, 0.25);
}

TEST_CASE("gravity makes the contact longer than half a period") {
  check_step(3, 1.25, 10, 48, 10);
  check_step(2, 0.05, 10, 32, 6);
  check_step(2, 100, 10, 3200, 20);
}

TEST_CASE("a body that is released at the surface stays for a period") {
  check_step(3, 0, 10, 12, 10);
  check_step(0.25, 0, 9.81, 100, 25);
  check_step(3, 1.25, 10, 48, 1);
}

TEST_CASE("random falls agree with exact arithmetic and with the reference") {
  generators::Random random(seed(0));
  for (int asked = 0; asked < 200; ++asked) {
    const double mass = random.uniform(0.1, 20), height = random.uniform(0.01, 10);
    const double gravity = random.uniform(1, 20), overlap = random.uniform(0.01, 1);
    const double stiffness = random.uniform(10, 5000);
    const int steps = random.integer(1, 50);
    shrinkable(check_stiffness, is_fall, mass, height, gravity, overlap);
    shrinkable(check_step, is_contact, mass, height, gravity, stiffness, steps);
  }
}
