// Right answers are the closed form, and bisection with the function of the references whose error
// is bounded. The first questions of a test each bring one mistake to light that no question before
// did.
#include "damping_for_restitution.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <16_penalty/damping_with_mistakes.hpp>

namespace {

using namespace contact::testing;
using damping_with_mistakes::ForceWay;
using damping_with_mistakes::Way;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double critical(double stiffness, double mass) { return 2 * std::sqrt(stiffness * mass); }

bool near(double got, double other) { return std::abs(got - other) <= 1e-6 * std::abs(other); }

// ---------------------------------------------------------------- questions

constexpr std::string_view kPenetration =
    "Which damping gives this restitution, if the contact ends at zero penetration?";
constexpr std::string_view kForce =
    "Which damping gives this restitution, if the contact ends at zero force?";

void check_penetration(double restitution, double stiffness, double mass) {
  const auto with = [&](Way way) {
    return [&, way] {
      return damping_with_mistakes::to_zero_penetration(restitution, stiffness, mass, way);
    };
  };
  const bool none = restitution == 0;
  std::vector<Suspect<double>> suspects;
  const auto suspect = [&](std::string_view id, Way way, bool where) {
    if (where) suspects.push_back({id, with(way)});
  };
  suspect("common-logarithm", Way::common_logarithm, !none);
  suspect("small-damping-assumed", Way::small_damping, !none);
  suspect("decay-of-a-whole-period", Way::whole_period, !none);
  suspect("restitution-squared", Way::squared, !none);
  suspect("damping-is-what-is-lost", Way::linear, !none);
  suspect("damping-negative", Way::negative, !none);
  suspect("ratio-for-damping", Way::ratio_alone, !none);
  suspect("half-of-the-damping", Way::half, !none);
  suspect("damping-without-the-root", Way::no_root, !none);
  suspect("damping-from-the-frequency", Way::frequency, !none);
  suspect("damping-without-the-mass", Way::no_mass, !none);
  suspect("root-in-the-logarithm", Way::in_the_logarithm, !none);
  if (!none) {
    const double ratio =
        damping_with_mistakes::ratio_for(-std::log(restitution), 2) * critical(stiffness, mass);
    suspects.push_back(
        {"other-end-of-the-contact", std::function<bool(const double&)>([=](const double& got) {
           return restitution < 1 && near(got, ratio);
         })});
  } else {
    suspects.push_back(
        {"no-rebound-is-not-a-number", std::function<bool(const double&)>(
                                           [](const double& got) { return !std::isfinite(got); })});
    suspects.push_back(
        {"no-rebound-without-a-damper",
         std::function<bool(const double&)>([](const double& got) { return got == 0; })});
  }
  const double right =
      none ? critical(stiffness, mass)
           : damping_with_mistakes::to_zero_penetration(restitution, stiffness, mass, Way::none);
  // Two of a logarithm and of a sum of squares with its root, and five operations: 10 u each.
  ask(kPenetration)
      .given("restitution", restitution)
      .given("stiffness", stiffness)
      .given("mass", mass)
      .suspects(std::move(suspects))
      .answer([&] { return exercise::damping_to_zero_penetration(restitution, stiffness, mass); })
      .close_to(right, within(64 * 0x1p-53 * right));
}

void check_force(double restitution, double stiffness, double mass) {
  const double right =
      damping_with_mistakes::to_zero_force(restitution, stiffness, mass, ForceWay::none);
  const double limit = critical(stiffness, mass);
  const bool strong = right > limit;
  std::vector<Suspect<double>> suspects;
  const auto suspect = [&](std::string_view id, ForceWay way) {
    if (restitution == 1) return;
    suspects.push_back({id, [&, way] {
                          return damping_with_mistakes::to_zero_force(restitution, stiffness, mass,
                                                                      way);
                        }});
  };
  suspect("exponent-to-the-greatest-depth", ForceWay::to_the_depth);
  suspect("sine-left-out", ForceWay::sine_left_out);
  suspect("common-logarithm", ForceWay::common_logarithm);
  suspect("ratio-for-damping", ForceWay::ratio_alone);
  suspect("half-of-the-damping", ForceWay::half);
  const auto look = [&](std::string_view id, bool where,
                        std::function<bool(const double&)> looks_like) {
    if (where) suspects.push_back({id, std::move(looks_like)});
  };
  const double closed = restitution == 1 ? 0
                                         : damping_with_mistakes::to_zero_penetration(
                                               restitution, stiffness, mass, Way::none);
  look("other-end-of-the-contact", restitution < 1,
       [=](const double& got) { return near(got, closed); });
  look("bisection-keeps-the-wrong-half", !strong && restitution < 1,
       [=](const double& got) { return near(got, limit) || std::abs(got) <= 1e-6 * limit; });
  look("ratio-at-most-one", strong, [=](const double& got) { return near(got, limit); });
  ask(kForce)
      .given("restitution", restitution)
      .given("stiffness", stiffness)
      .given("mass", mass)
      .suspects(std::move(suspects))
      .answer([&] { return exercise::damping_to_zero_force(restitution, stiffness, mass); })
      .close_to(right, within(1e-6 * limit));
}

void check_refused(double restitution, bool at_zero_force) {
  const double stiffness = 12, mass = 3;
  const auto answer = [&] {
    return at_zero_force ? exercise::damping_to_zero_force(restitution, stiffness, mass)
                         : exercise::damping_to_zero_penetration(restitution, stiffness, mass);
  };
  const char* id = std::isnan(restitution) ? "nan-not-refused"
                   : restitution > 1       ? "gain-not-refused"
                   : restitution < 0       ? "negative-restitution-not-refused"
                                           : "no-rebound-not-refused";
  ask(at_zero_force ? kForce : kPenetration)
      .given("restitution", restitution)
      .given("stiffness", stiffness)
      .given("mass", mass)
      .suspect_if(id, [](const double&) { return true; })
      .answer(answer)
      .throws_invalid_argument();
}

bool are_in_range(double restitution, double stiffness, double mass) {
  return restitution >= 1e-4 && restitution < 1 && stiffness >= 0.01 && mass >= 0.01 &&
         stiffness <= 1e6 && mass <= 1e6;
}

}  // namespace

TEST_CASE("half of the speed returns at zero penetration") {
  check_penetration(0.5, 12, 3);
  check_penetration(0.9, 100, 4);
  check_penetration(0.01, 12, 3);
  check_penetration(1, 12, 3);
}

TEST_CASE("critical damping is the smallest without a rebound") {
  check_penetration(0, 12, 3);
  check_penetration(0, 100, 4);
  check_penetration(0.0001, 12, 3);
}

TEST_CASE("no damper gives a restitution that is not from 0 to 1") {
  check_penetration(0.5, 12, 3);
  check_penetration(0.25, 12, 3);
  check_refused(1.5, false);
  check_refused(-0.5, false);
  check_refused(kNan, false);
  check_refused(kInfinity, false);
}

TEST_CASE("half of the speed returns at zero force") {
  check_force(0.5, 12, 3);
  check_force(0.9, 100, 4);
  check_force(0.25, 12, 3);
  check_force(1, 12, 3);
}

TEST_CASE("little speed returns at zero force") {
  check_force(0.125, 12, 3);
  check_force(0.01, 100, 4);
  check_force(0.0001, 12, 3);
}

TEST_CASE("no damper stops the body at zero force") {
  check_force(0.5, 12, 3);
  check_force(0.25, 12, 3);
  check_refused(0, true);
  check_refused(2, true);
  check_refused(-1, true);
  check_refused(kNan, true);
}

TEST_CASE("random restitutions agree with the closed form and with bisection") {
  generators::Random random(seed(0));
  for (int asked = 0; asked < 300; ++asked) {
    const double restitution = random.uniform(0.001, 0.999);
    const double stiffness = random.uniform(1, 1000), mass = random.uniform(0.1, 20);
    shrinkable(check_penetration, are_in_range, restitution, stiffness, mass);
    shrinkable(check_force, are_in_range, restitution, stiffness, mass);
  }
}
