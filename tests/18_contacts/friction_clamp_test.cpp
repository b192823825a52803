// Right answers come from exact arithmetic on the numbers as they are stored, with one square root.
// The first questions of a test each bring one mistake to light that no question before did.
#include "friction_clamp.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>
#include <support/shrinkable.hpp>

#include <contact/exact.hpp>

#include <18_contacts/friction_with_mistakes.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using exercise::Friction;
using friction_with_mistakes::NormalWay;
using friction_with_mistakes::Way;
using Vector = Eigen::Vector2d;

// ---------------------------------------------------------------- what is right

double right_normal(double sum, double velocity, double mass) {
  const Exact stopped = Exact(sum) - Exact(velocity) * Exact(mass);
  return stopped.sign() < 0 ? 0 : rounded<double>(stopped);
}

Exact stopped(double sum, double slip, double mass) {
  return Exact(sum) - Exact(slip) * Exact(mass);
}

Friction right_friction(const Vector& sum, const Vector& slip, double mass, double mu,
                        double normal) {
  const Exact x = stopped(sum.x(), slip.x(), mass), y = stopped(sum.y(), slip.y(), mass);
  const Exact most = Exact(mu) * Exact(normal), square = x * x + y * y;
  const bool sticks = square <= most * most;
  Vector after{rounded<double>(x), rounded<double>(y)};
  // The quotient of the squares is rounded once, so its root is off by 1 u.
  if (!sticks) after *= std::sqrt(quotient<double>(most * most, square));
  return {after, after - sum, sticks};
}

// ---------------------------------------------------------------- questions

void check_normal(double sum, double velocity, double mass) {
  std::vector<Suspect<double>> suspects;
  // A hint must be true of the answer in hand: these are asked only where it is.
  const auto suspect = [&](std::string_view id, NormalWay way, bool where = true) {
    if (!where) return;
    suspects.push_back(
        {id, [=] { return friction_with_mistakes::normal_sum(sum, velocity, mass, way); }});
  };
  const bool pull = sum - velocity * mass < 0;
  suspect("normal-change-clamped", NormalWay::change_clamped, sum > 0 && velocity > 0);
  suspect("impulse-with-the-velocity", NormalWay::reversed, velocity != 0);
  suspect("accumulated-impulse-pulls", NormalWay::pulls, pull);
  suspect("accumulated-impulse-forgotten", NormalWay::forgets, sum > 0);
  suspect("velocity-over-effective-mass", NormalWay::divided, velocity != 0);
  suspect("change-for-the-sum", NormalWay::change_returned, sum > 0);
  suspect("accumulated-impulse-as-a-magnitude", NormalWay::magnitude, pull);
  ask("What is the sum of the normal impulses after the visit?")
      .given("sum", sum)
      .given("velocity", velocity)
      .given("effective mass", mass)
      .suspects(std::move(suspects))
      .answer([&] { return exercise::normal_sum(sum, velocity, mass); })
      .close_to(right_normal(sum, velocity, mass),
                within(4 * 0x1p-53 * (sum + std::abs(velocity) * mass)));
}

void check_friction(const Vector& sum, const Vector& slip, double mass, double mu, double normal) {
  const Friction right = right_friction(sum, slip, mass, mu, normal);
  std::vector<Suspect<Friction>> suspects;
  const auto suspect = [&](std::string_view id, Way way, bool where = true) {
    if (!where) return;
    suspects.push_back({id, [=, &sum, &slip] {
                          return friction_with_mistakes::friction_after(sum, slip, mass, mu, normal,
                                                                        way);
                        }});
  };
  const bool slides = !right.sticks, slips = !slip.isZero(0), loaded = !sum.isZero(0);
  suspect("friction-change-clamped", Way::change_clamped, loaded);
  suspect("friction-clamped-on-each-axis", Way::each_axis, slides);
  suspect("friction-against-the-slip-of-now", Way::along_slip, slides && loaded);
  suspect("friction-without-a-limit", Way::no_limit, slides);
  suspect("sliding-without-friction", Way::let_go, slides);
  suspect("limit-without-the-normal-impulse", Way::mu_alone);
  suspect("limit-without-the-coefficient", Way::normal_alone);
  suspect("friction-along-the-slip", Way::with_slip, slips);
  suspect("accumulated-friction-forgotten", Way::forgets, loaded);
  suspect("friction-applied-without-the-limit", Way::whole_change, slides);
  suspect("accumulated-friction-applied-again", Way::sum_applied, loaded);
  suspect("applied-friction-reversed", Way::change_reversed);
  suspect("friction-always-at-the-limit", Way::always_longest, !slides);
  suspect("sticking-and-sliding-exchanged", Way::sticks_reversed);
  suspect("edge-of-the-disc-slides", Way::sticks_strict);
  suspect("sticking-by-the-slip-before", Way::sticks_by_slip);
  suspect("slip-over-effective-mass", Way::divided, slips);
  suspect("square-for-the-length", Way::square);
  // Sum, product and scaling: 5 u of the magnitudes.
  const double size = sum.norm() + slip.norm() * mass;
  ask("What are the friction impulses after the visit?")
      .given("sum", sum)
      .given("slip", slip)
      .given("effective mass", mass)
      .given("mu", mu)
      .given("normal", normal)
      .suspects(std::move(suspects))
      .answer([&] { return exercise::friction_after(sum, slip, mass, mu, normal); })
      .close_to(right, within(16 * 0x1p-53 * size));
}

bool is_contact(double sum, double velocity, double mass) {
  return sum >= 0 && mass > 0 && std::max({sum, std::abs(velocity), mass}) <= 100;
}

/// Whether rounding cannot change whether it sticks.
bool is_clear(const Vector& sum, const Vector& slip, double mass, double mu, double normal) {
  if (!(mass > 0) || mu < 0 || normal < 0) return false;
  const double size = std::max(sum.cwiseAbs().maxCoeff(), slip.cwiseAbs().maxCoeff());
  if (std::max({size, mass, mu, normal}) > 100) return false;
  return std::abs(Vector(sum - slip * mass).norm() - mu * normal) >= 1e-6;
}

const Vector kNone{0, 0};

}  // namespace

TEST_CASE("a visit changes the sum by the velocity") {
  check_normal(9, 3, 2);
  check_normal(4, -3, 2);
  check_normal(0, -0.5, 8);
}

TEST_CASE("the sum of the normal impulses is a push") {
  check_normal(5, 4, 2);
  check_normal(0, 4, 2);
  check_normal(6, 3, 2);
  check_normal(6, 2.5, 2);
}

TEST_CASE("a small slip is stopped") {
  check_friction({4, -3}, kNone, 3, 2, 9);
  check_friction({-1, 3}, {3, -1}, 2, 0.5, 40);
  check_friction({1, 2}, {3, -1}, 2, 0.5, 40);
  check_friction({4, -3}, {-1, 2}, 3, 2, 9);
}

TEST_CASE("friction is at most mu times the normal impulse") {
  check_friction(kNone, {3, 4}, 2, 0.5, 4);
  check_friction(kNone, {-4, 3}, 0.5, 0.25, 4);
  check_friction(kNone, {3, 0}, 2, 0.5, 0);
}

TEST_CASE("the limit is the same in all directions") {
  check_friction(kNone, {1.5, 2}, 2, 0.5, 9);
  check_friction(kNone, {-1, 2}, 2, 0.5, 2);
  check_friction(kNone, {-0.25, -6}, 1, 0.5, 8);
}

TEST_CASE("the limit is one of the sum") {
  check_friction({3, 4}, {-2, 1}, 2, 0.5, 9);
  check_friction({-3, 3}, {1.5, -0.5}, 2, 1, 5);
  check_friction({3, 0}, {-1, -1}, 1, 0.5, 6);
  check_friction({3, 4}, kNone, 2, 0.5, 5);
}

TEST_CASE("on the edge of the disc the contact sticks") {
  check_friction(kNone, {3, -4}, 2, 0.5, 20);
  check_friction({3, 4}, kNone, 2, 0.5, 10);
  check_friction(kNone, kNone, 2, 0.5, 0);
  check_friction(kNone, {3, -4}, 2, 0.5, 16);
}

TEST_CASE("random visits agree with exact arithmetic") {
  generators::Random random(seed(0));
  const auto vector = [&](double size) {
    return Vector{random.uniform(-size, size), random.uniform(-size, size)};
  };
  for (int asked = 0; asked < 300;) {
    const double mass = random.uniform(0.1, 4), old = random.uniform(0, 6);
    const double velocity = random.uniform(-4, 4), mu = random.uniform(0, 1.5);
    const Vector sum = vector(3), slip = vector(2);
    const double normal = random.uniform(0, 8);
    if (!is_clear(sum, slip, mass, mu, normal)) continue;
    ++asked;
    shrinkable(check_normal, is_contact, old, velocity, mass);
    shrinkable(check_friction, is_clear, sum, slip, mass, mu, normal);
  }
}
