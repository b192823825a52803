// What the functions of the chapter return for very large and very small numbers: values that are
// known in closed form, limits, and refusals.
#include <algorithm>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/hunt_crossley_duration.hpp>
#include <contact/penalty_force.hpp>
#include <contact/soft_to_rigid.hpp>
#include <contact/spring_stack.hpp>
#include <contact/squash.hpp>
#include <contact/tolerance.hpp>
#include <limits>
#include <vector>

#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/refusal.hpp"

namespace extreme_numbers_test {
namespace {

using contact::ContactExponent;
using contact::hunt_crossley;
using contact::SpringDamper;
using contact::Vector3;
using generators::Random;
using oracle::Rational;
using support::contains;
using support::refusal;

constexpr double kUnit = 0x1p-53;
constexpr double kPi = 3.141592653589793;

/// Whether two numbers differ by at most a share of the second.
bool near(double got, double right, double share) { return std::abs(got / right - 1) <= share; }

TEMPLATE_TEST_CASE("bounds of a frequency whose row underflows are neighbours around it", "", float,
                   double) {
  using S = TestType;
  using Limits = std::numeric_limits<S>;
  Random random(1731);
  int zero = 0;
  for (int i = 0; i < generators::tried(60); ++i) {
    const int range = Limits::max_exponent / 2;
    const int least = Limits::digits / 2 + 4;
    // The first is the extreme one, so that few tries meet it too.
    const int up = i == 0 ? least : random.integer(-6, least);
    const int down = i == 0 ? -least : random.integer(-least, 6);
    const S m = std::ldexp(S(random.uniform(1, 2)), range + up);
    const S k = std::ldexp(S(random.uniform(1, 2)), -range + down);
    const auto stack = contact::spring_stack<S>({m, m}, {k, k});
    for (const std::size_t j : {0, 1}) {
      const auto bounds = contact::frequency_bounds(stack, j);
      INFO(m << " " << k << " " << bounds.below << " " << bounds.above);
      REQUIRE(bounds.above == std::nextafter(bounds.below, Limits::infinity()));
      REQUIRE(contact::frequencies_below(stack, bounds.below) <= j);
      REQUIRE(contact::frequencies_below(stack, bounds.above) > j);
      zero += bounds.below == S(0);
    }
    const S h = contact::stack_step_limit(stack);
    REQUIRE(std::isfinite(h));
    const contact::SpringStack<Rational> exact{{oracle::exact(m), oracle::exact(m)},
                                               {oracle::exact(k), oracle::exact(k)}};
    const Rational square = oracle::exact(h) * oracle::exact(h);
    REQUIRE(contact::frequencies_below<Rational>(exact, 4 / square) == 2);
  }
  CHECK(zero > 0);
}

TEST_CASE("the step limit of a light spring under a huge mass is finite and below 2 / ω") {
  const auto stack = contact::spring_stack<double>({1e200}, {1e-200});
  const auto bounds = contact::frequency_bounds(stack, 0);
  CHECK(bounds.below == 0);
  CHECK(bounds.above == std::numeric_limits<double>::denorm_min());
  const double limit = contact::stack_step_limit(stack);
  CHECK(limit > 0);
  CHECK(limit < 2e200);
}

TEMPLATE_TEST_CASE("the penetration far from the origin is within its bound, n · c too", "", float,
                   double) {
  using S = TestType;
  Random random(1732);
  const Rational u = oracle::exact(contact::tolerance::unit_roundoff<S>);
  int beyond = 0;  // where |n · c| in place of the sum is too small a bound
  for (int i = 0; i < generators::tried(3000); ++i) {
    const double angle = random.uniform(0.1, 0.9);
    const Vector3<S> n(S(angle), S(std::sqrt(1 - angle * angle)), S(0));
    const S far = S(std::abs(random.magnitude(0, 30)));
    const contact::PenaltyBall<S> ball{{Vector3<S>(n.y() * far, -n.x() * far, S(0)), S(1)},
                                       Vector3<S>::Zero()};
    const contact::Plane<S> plane{n, S(0)};
    const auto got = contact::half_space_force(ball, plane, SpringDamper<S>{S(1), S(0)});
    if (!got.touching) continue;
    const auto normal = oracle::exact(n);
    const auto centre = oracle::exact(ball.sphere.centre);
    const Rational along = normal.dot(centre);
    const Rational off = abs(oracle::exact(got.penetration) - (1 - along));
    REQUIRE(off <= 8 * u * (1 + abs(normal.x() * centre.x()) + abs(normal.y() * centre.y())));
    beyond += off > 8 * u * (1 + abs(along));
  }
  CHECK(beyond > generators::tried(300));
}

TEST_CASE("the overlap left by a strong damper does not underflow before it is small") {
  // For a large damping ratio ζ it is v m / c up to a share of ln ζ / ζ².
  const auto impact = contact::spring_impact(contact::spring_damper(1e-120, 1e50), 1e-120, 1.0);
  CHECK(near(impact.left_overlap, 1e-170, (100 + 100 * 783) * kUnit));
  CHECK(impact.restitution == 0);  // 1e-340
  const auto largest = contact::spring_impact(contact::spring_damper(1e-300, 1e300), 1e-300, 1.0);
  CHECK(std::isfinite(largest.left_overlap));
}

TEST_CASE("a damper that would vanish when it is scaled is refused") {
  CHECK(contains(refusal([] { contact::stiffened(contact::spring_damper(1e200, 1e-300), 1e-30); }),
                 "factor"));
  CHECK(contact::stiffened(contact::spring_damper(1e200, 0.0), 1e-30).damping == 0);
}

TEMPLATE_TEST_CASE("the contact of two balls is the same in both orders, at every size", "", float,
                   double) {
  using S = TestType;
  Random random(1733);
  const auto steel = contact::elastic_solid(S(2e11), S(0.3));
  const auto rubber = contact::elastic_solid(S(1e7), S(0.5));
  for (int i = 0; i < generators::tried(1000); ++i) {
    const S one = std::max(std::abs(generators::any_finite<S>(random)), S(1e-30));
    const S two = std::max(std::abs(generators::any_finite<S>(random)), S(1e-30));
    const S stiffness = contact::hertz_contact(one, steel, two, rubber).stiffness;
    REQUIRE(stiffness == contact::hertz_contact(two, rubber, one, steel).stiffness);
    // A far larger ball is a half-space.
    if (one < two * std::numeric_limits<S>::epsilon() / S(4))
      REQUIRE(stiffness == contact::hertz_contact(one, steel, rubber).stiffness);
  }
  CHECK(contains(refusal([&] { contact::hertz_contact(S(0), steel, S(1), steel); }),
                 "first_radius = 0"));
  const S inf = std::numeric_limits<S>::infinity();
  CHECK(
      contains(refusal([&] { contact::hertz_contact(inf, steel, S(1), steel); }), "first_radius"));
}

TEMPLATE_TEST_CASE("the dissipation for a tiny restitution gives it back, or is refused", "", float,
                   double) {
  using S = TestType;
  Random random(1734);
  const S u = contact::tolerance::unit_roundoff<S>;
  int refused = 0;
  int given = 0;
  for (int i = 0; i < generators::tried(1000); ++i) {
    const S e = std::ldexp(S(random.uniform(0.5, 1)),
                           random.integer(std::numeric_limits<S>::min_exponent - 20, 0));
    const S v = std::abs(generators::any_finite<S>(random));
    if (!(v > S(0))) continue;
    S lambda(0);
    INFO(e << " " << v);
    if (!refusal([&] { lambda = contact::dissipation_for(e, v); }).empty()) {
      REQUIRE(oracle::exact(e) * oracle::exact(v) * oracle::exact(std::numeric_limits<S>::max()) <=
              1);
      ++refused;
      continue;
    }
    REQUIRE(std::isfinite(lambda));
    if (lambda < std::numeric_limits<S>::min()) continue;
    const S back = contact::hunt_crossley_restitution(hunt_crossley(S(1), lambda), v);
    if (e > std::numeric_limits<S>::min()) REQUIRE(std::abs(back - e) <= S(100) * u * e);
    ++given;
  }
  CHECK(given > generators::tried(300));
  CHECK(refused > generators::tried(50));
  CHECK(!refusal([] { contact::dissipation_for(1e-310, 1.0); }).empty());
  CHECK(near(contact::dissipation_for(1e-310, 1e10), 1e300, 1e-12));
}

TEST_CASE("force and energy of a contact for numbers that are not finite") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const auto spring = contact::spring_damper(1.0, 1.0);
  CHECK(contact::contact_spring_energy(spring, nan) == 0);
  CHECK(contact::contact_spring_energy(spring, inf) == inf);
  CHECK(std::isnan(contact::contact_force(spring, 1.0, nan)));
  CHECK(std::isnan(contact::contact_force(spring, inf, -inf)));
  CHECK(std::isnan(contact::contact_force(contact::spring_damper(1.0, 0.0), 1.0, -inf)));
  CHECK(contact::contact_force(spring, 1.0, inf) == inf);
}

TEMPLATE_TEST_CASE("an attached motion starts at its start, whatever its damping", "", float,
                   double) {
  using S = TestType;
  Random random(1735);
  const int range = sizeof(S) == sizeof(float) ? 49 : 398;
  for (int i = 0; i < generators::tried(2000); ++i) {
    const S k = S(std::abs(random.magnitude(-range, range)));
    const S c = S(std::abs(random.magnitude(-range / 2, range / 2)));
    const S m = S(std::abs(random.magnitude(-range, range)));
    const contact::PenaltyState<S> start{S(random.uniform(-1, 1)), S(random.uniform(-1, 1))};
    const auto state = contact::damped_motion(start, SpringDamper<S>{k, c}, m, S(0), S(0));
    INFO(k << " " << c << " " << m);
    REQUIRE(state.penetration == start.penetration);
    REQUIRE(state.approach == start.approach);
  }
}

TEST_CASE("a strong damper lets a spring creep back with the rate k / c") {
  // (c / m)² overflows.
  const SpringDamper<double> spring{1, 1e60};
  const auto state =
      contact::damped_motion(contact::PenaltyState<double>{1, 0}, spring, 1e-120, 0.0, 1e60);
  CHECK(near(state.penetration, 0.36787944117144233, 20 * kUnit));
}

TEST_CASE("a squashed ball of the least size has an axis of 0") {
  const double least = std::numeric_limits<double>::denorm_min();
  const auto flat = contact::squash(least, 1.0, contact::SquashKeeps::area);
  CHECK(flat.held);
  CHECK(flat.along == 0);
  CHECK(flat.across >= least);
}

TEST_CASE("the duration with little dissipation is that without, at every size") {
  Random random(1736);
  for (int i = 0; i < generators::tried(500); ++i) {
    const double k = std::max(std::abs(generators::any_finite<double>(random)), 1e-305);
    const double m = std::max(std::abs(generators::any_finite<double>(random)), 1e-305);
    const double v = std::max(std::abs(generators::any_finite<double>(random)), 1e-305);
    const double lambda = random.chance(0.5) ? 0 : random.uniform(0, 1e-15) / std::max(v, 1e-290);
    INFO(k << " " << m << " " << v << " " << lambda);
    const auto linear = hunt_crossley(k, lambda, ContactExponent::linear);
    const double period = kPi * (std::sqrt(m) / std::sqrt(k));
    REQUIRE(near(contact::hunt_crossley_duration(linear, m, v), period, 1.1e-13));
    const double hertz = contact::hertz_impact(contact::hertz_contact(k), m, v).duration;
    if (!std::isnormal(hertz)) continue;
    REQUIRE(near(contact::hunt_crossley_duration(hunt_crossley(k, lambda), m, v), hertz, 1.1e-13));
  }
}

TEST_CASE("durations whose dissipation or depth underflows, or whose speed is huge") {
  const auto slight = hunt_crossley(1.0, 1e-310, ContactExponent::linear);
  CHECK(near(contact::hunt_crossley_duration(slight, 1.0, 1e-11), kPi, 1e-13));
  const auto hard = hunt_crossley(1e300, 0.0);
  const double right =
      contact::hertz_impact(contact::hertz_contact(1e300), 1e-300, 1e-200).duration;
  CHECK(right > 3e-200);
  CHECK(near(contact::hunt_crossley_duration(hard, 1e-300, 1e-200), right, 1e-13));
  const auto spring = hunt_crossley(1.0, 0.0, ContactExponent::linear);
  CHECK(near(contact::hunt_crossley_duration(spring, 1e10, 1e308), kPi * 1e5, 1e-13));
}

}  // namespace
}  // namespace extreme_numbers_test
