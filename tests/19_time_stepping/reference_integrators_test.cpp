// integrators.hpp and spring_motion.hpp: steps against closed forms, in fractions.
#include <array>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/advance.hpp>
#include <contact/ballistic.hpp>
#include <contact/integrators.hpp>
#include <contact/spring_motion.hpp>
#include <limits>
#include <string>

#include "reference.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/refusal.hpp"
#include "support/rounding.hpp"

using contact::Integrator;
using contact::MotionState;
using generators::Random;
using oracle::Rational;
using reference::fraction;
using reference::point;
using reference::positive;
using rounding::u;
using support::contains;
using support::refusal;

namespace {

using Line = MotionState<Rational>;

constexpr std::array all_integrators{Integrator::explicit_euler, Integrator::semi_implicit_euler,
                                     Integrator::velocity_verlet, Integrator::position_verlet,
                                     Integrator::runge_kutta_4};

}  // namespace

TEST_CASE("in a free fall the two Euler methods are off by ∓g h t / 2, and the others are exact") {
  Random random(1901);
  for (int i = 0; i < 300; ++i) {
    const oracle::Vector gravity = point(random, 12);
    const MotionState<oracle::Vector> start{point(random, 5), point(random, 9)};
    const Rational h = positive(random, 1) / 10;
    const int steps = random.integer(1, 20);
    const Rational t = h * steps;
    const oracle::Vector right = oracle::ballistic(start.position, start.velocity, gravity, t);
    const oracle::Vector off = gravity * Rational(h * t / 2);
    const auto law = [&gravity](const oracle::Vector&) { return gravity; };
    for (const Integrator integrator : all_integrators) {
      const auto got = contact::integrate(integrator, start, h, steps, law);
      oracle::Vector wanted = right;
      if (integrator == Integrator::explicit_euler) wanted -= off;
      if (integrator == Integrator::semi_implicit_euler) wanted += off;
      REQUIRE(got.position == wanted);
      REQUIRE(got.velocity == oracle::Vector(start.velocity + gravity * t));
    }
    const auto flown = contact::ballistic_motion(start, gravity, t);
    REQUIRE(flown.position == right);
    REQUIRE(flown.velocity == oracle::Vector(start.velocity + gravity * t));
  }
}

TEST_CASE("the energy of a spring after each step, as identities") {
  Random random(1902);
  for (int i = 0; i < 300; ++i) {
    const auto spring = contact::linear_spring<Rational>(positive(random, 5));
    const Rational w = spring.angular_frequency;
    const Rational h = positive(random, 1) / 4;
    const Rational z2 = w * w * h * h;
    const Line before{fraction(random, 3), fraction(random, 3)};
    const Rational kinetic = before.velocity * before.velocity;
    const Rational stretch = w * w * before.position * before.position;
    const auto parts = [&w](const Line& s) {
      return std::pair<Rational, Rational>(s.velocity * s.velocity,
                                           w * w * s.position * s.position);
    };
    const Rational energy = contact::spring_energy(spring, before);
    REQUIRE(energy == (kinetic + stretch) / 2);

    const Line explicit_euler = contact::explicit_euler_step(before, h, spring);
    REQUIRE(contact::spring_energy(spring, explicit_euler) == energy * (1 + z2));

    const Line euler = contact::semi_implicit_euler_step(before, h, spring);
    const auto kept = [&](const Line& s) {
      const auto [k, p] = parts(s);
      return Rational(k + p - h * w * w * s.position * s.velocity);
    };
    REQUIRE(kept(euler) == kept(before));

    const auto by_velocity = parts(contact::velocity_verlet_step(before, h, spring));
    REQUIRE(by_velocity.first + by_velocity.second * (1 - z2 / 4) ==
            kinetic + stretch * (1 - z2 / 4));
    const auto by_position = parts(contact::position_verlet_step(before, h, spring));
    REQUIRE(by_position.first * (1 - z2 / 4) + by_position.second ==
            kinetic * (1 - z2 / 4) + stretch);

    const Line kutta = contact::runge_kutta_4_step(before, h, spring);
    const Rational z6 = z2 * z2 * z2;
    REQUIRE(contact::spring_energy(spring, kutta) == energy * (1 - z6 / 72 + z6 * z2 / 576));
  }
}

TEST_CASE("Verlet's steps are reversible, and the others are not") {
  Random random(1903);
  for (int i = 0; i < 200; ++i) {
    const Rational pull = positive(random, 4);
    const auto law = [&pull](const Rational& x) { return Rational(-pull * x * (1 + x * x)); };
    const Line start{positive(random, 2), fraction(random, 2)};
    const Rational h = positive(random, 1) / 8;
    for (const Integrator integrator : all_integrators) {
      const Line there = contact::motion_step(integrator, start, h, law);
      const Line back = contact::motion_step(integrator, there, Rational(-h), law);
      const bool same = back.position == start.position && back.velocity == start.velocity;
      const bool verlet =
          integrator == Integrator::velocity_verlet || integrator == Integrator::position_verlet;
      REQUIRE(same == verlet);
    }
  }
}

TEST_CASE("halving the step halves, quarters or divides by sixteen the error") {
  // The leading term of the error is c hᵖ t, the next one of order h^(p+1): with ω h = 1/50 and
  // halved, the ratio is 2ᵖ to within some per cent. A tenth is asked for.
  const auto spring = contact::linear_spring(1.0);
  const MotionState<double> start{1, 0.5};
  const double t = 2;
  const auto truth = contact::spring_motion(spring, start, t);
  const auto off = [&](Integrator integrator, int steps) {
    const auto end = contact::integrate(integrator, start, t / steps, steps, spring);
    return std::hypot(end.position - truth.position, end.velocity - truth.velocity);
  };
  for (const auto& [integrator, ratio] :
       {std::pair(Integrator::explicit_euler, 2.0), std::pair(Integrator::semi_implicit_euler, 2.0),
        std::pair(Integrator::velocity_verlet, 4.0), std::pair(Integrator::position_verlet, 4.0),
        std::pair(Integrator::runge_kutta_4, 16.0)}) {
    const double found = off(integrator, 100) / off(integrator, 200);
    INFO(static_cast<int>(integrator) << ": " << found);
    CHECK(found > 0.9 * ratio);
    CHECK(found < 1.1 * ratio);
  }
}

TEST_CASE("implicit Euler divides the energy of a spring by 1 + (ω h)², and brings it to rest") {
  Random random(1939);
  for (int i = 0; i < 300; ++i) {
    const auto spring = contact::linear_spring<Rational>(positive(random, 5));
    const Rational h = positive(random, 3);
    const Line before{fraction(random, 3), fraction(random, 3)};
    const Line after = contact::implicit_euler_step(before, h, spring);
    REQUIRE(after.position == before.position + h * after.velocity);
    REQUIRE(after.velocity == before.velocity + h * spring(after.position));
    const Rational z = spring.angular_frequency * h;
    REQUIRE(contact::spring_energy(spring, after) * (1 + z * z) ==
            contact::spring_energy(spring, before));
    // The adjoint: explicit Euler with −h undoes it.
    const Line back = contact::explicit_euler_step(after, Rational(-h), spring);
    REQUIRE(back.position == before.position);
    REQUIRE(back.velocity == before.velocity);
  }
  const auto spring = contact::linear_spring(1.0);
  for (const double h : {0.1, 1.0, 10.0}) {
    MotionState<double> now{1, 0};
    const int steps = 4000;
    for (int i = 0; i < steps; ++i) now = contact::implicit_euler_step(now, h, spring);
    // The amplitude is 1 / √(1 + h²) a step: for h = 0.1 it is 2.3e-9 after 4,000 steps.
    CHECK(std::hypot(now.position, now.velocity) < 1e-8);
  }
}

TEMPLATE_TEST_CASE("steps in floating point are near the steps in fractions", "", float, double) {
  using S = TestType;
  Random random(1904);
  for (int i = 0; i < 500; ++i) {
    const S w = S(random.uniform(0.5, 4));
    const S h = S(random.uniform(0.001, 0.2));
    const S x = S(random.uniform(-3, 3));
    const S v = S(random.uniform(-3, 3));
    const auto spring = contact::linear_spring(w);
    const auto exact = contact::linear_spring(oracle::exact(w));
    for (const Integrator integrator : all_integrators) {
      const auto got = contact::motion_step(integrator, MotionState<S>{x, v}, h, spring);
      const Line right = contact::motion_step(integrator, Line{oracle::exact(x), oracle::exact(v)},
                                              oracle::exact(h), exact);
      // Runge and Kutta's step has the longest chain: 40 roundings, of numbers no larger than
      // (1 + ω² + ω) (|x| + |v|) < 21 · 6.
      REQUIRE(oracle::exact(oracle::error(double(got.position), right.position)) <=
              40 * 126 * u<S>());
      REQUIRE(oracle::exact(oracle::error(double(got.velocity), right.velocity)) <=
              40 * 126 * u<S>());
    }
  }
}

TEST_CASE("the motion on a spring agrees with intervals") {
  Random random(1905);
  for (int i = 0; i < 600; ++i) {
    const double w = random.uniform(0.1, 20);
    const double t = random.uniform(-30, 30);
    const double x = random.uniform(-2, 2);
    const double v = random.uniform(-2, 2);
    const auto got = contact::spring_motion(contact::linear_spring(w), {x, v}, t);
    const auto number = [](double value) { return oracle::Interval(oracle::exact(value), 160); };
    const oracle::Interval angle = number(w) * number(t);
    const auto place = oracle::enclose(number(x) * cos(angle) + number(v) / number(w) * sin(angle));
    const auto speed = oracle::enclose(number(v) * cos(angle) - number(w) * number(x) * sin(angle));
    const double room = (8 + 2 * w * std::abs(t)) * 0x1p-53 * (std::abs(x) + std::abs(v) / w);
    REQUIRE(place.error(got.position) <= room);
    REQUIRE(speed.error(got.velocity) <= w * room);
  }
}

TEST_CASE("invalid arguments are refused by name") {
  const auto contains = [](const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
  };
  const double infinite = std::numeric_limits<double>::infinity();
  CHECK(contains(refusal([] { contact::linear_spring(0.0); }), "angular_frequency = 0"));
  CHECK(contains(refusal([&] { contact::linear_spring(infinite); }), "angular_frequency"));
  CHECK(contains(refusal([] { contact::impact_rules(1.5, 0.0, 1); }), "restitution"));
  CHECK(contains(refusal([] { contact::impact_rules(1.0, -1.0, 1); }), "rest_speed"));
  CHECK(contains(refusal([] { contact::impact_rules(1.0, 0.0, -1); }), "max_impacts = -1"));
  CHECK(contains(refusal([] { contact::impact_rules(std::nan(""), 0.0, 1); }), "restitution"));
}
