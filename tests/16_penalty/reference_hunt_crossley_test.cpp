// Hunt and Crossley's contact: the restitution by the sign of its equation in intervals (class (c)
// of the oracle), the depth by the same logarithm, both against steps of the equation of motion.
#include <algorithm>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/hunt_crossley.hpp>
#include <contact/tolerance.hpp>
#include <limits>

#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/refusal.hpp"

namespace hunt_crossley_test {
namespace {

using contact::ContactExponent;
using contact::hunt_crossley;
using contact::hunt_crossley_restitution;
using contact::HuntCrossley;
using generators::Random;
using oracle::Interval;
using oracle::Rational;
using support::contains;
using support::refusal;

constexpr double kUnit = 0x1p-53;

Interval lift(const Rational& x) { return {x, 640}; }

/// p − ln(1 + p).
Interval compression(const Rational& p) { return lift(p) - log(lift(1 + p)); }
/// −q − ln(1 − q), for q below 1.
Interval expansion(const Rational& q) { return lift(-q) - log(lift(1 - q)); }

/// Whether the root e of −p e − ln(1 − p e) = p − ln(1 + p) is within `room` times got of it.
bool is_restitution(double got, const Rational& p, const Rational& room) {
  const Rational target_low = compression(p).low();
  const Rational target_high = compression(p).high();
  const Rational less = p * oracle::exact(got) * (1 - room);
  const Rational more = p * oracle::exact(got) * (1 + room);
  if (less >= 1 || expansion(less).low() > target_high) return false;
  return more >= 1 || expansion(more).high() >= target_low;
}

TEMPLATE_TEST_CASE("the restitution solves its equation, at every speed", "", float, double) {
  using S = TestType;
  Random random(1691);
  const Rational room = 40 * oracle::exact(kUnit) +
                        Rational(1001, 1000) * oracle::exact(contact::tolerance::unit_roundoff<S>);
  for (int i = 0; i < generators::tried(1500); ++i) {
    const S lambda = S(std::abs(random.magnitude(-30, 5)));
    const S speed = S(i % 3 == 0   ? random.uniform(0, 2) / double(lambda)
                      : i % 3 == 1 ? random.uniform(2, 40) / double(lambda)
                                   : std::abs(random.magnitude(-20, 20)));
    const Rational p = oracle::exact(lambda) * oracle::exact(speed);
    if (p == 0 || p > 300) continue;
    const S e = hunt_crossley_restitution(hunt_crossley(S(1), lambda), speed);
    INFO(lambda << " " << speed << " " << e);
    REQUIRE(e > S(0));
    REQUIRE(e <= S(1));
    REQUIRE(is_restitution(double(e), p, room));
  }
}

TEST_CASE("the restitution at the borders of its methods, and far from them") {
  const auto at = [](double p) {
    return hunt_crossley_restitution(HuntCrossley<double>{1, p, ContactExponent::hertz}, 1.0);
  };
  CHECK(at(0) == 1);
  CHECK(at(1e-300) == 1);
  CHECK(at(std::numeric_limits<double>::denorm_min()) == 1);
  for (double p = 0.5; p < 1.25; p += 0x1p-7)
    CHECK(is_restitution(at(p), oracle::exact(p), 40 * oracle::exact(kUnit)));
  for (const double p : {800.0, 1e10, 1e200}) CHECK(std::abs(at(p) * p - 1) < 4 * kUnit);
  // Also where λ v is near the largest number or beyond.
  const auto contact = [](double lambda) {
    return HuntCrossley<double>{1, lambda, ContactExponent::linear};
  };
  CHECK(std::abs(hunt_crossley_restitution(contact(1e302), 1.0) * 1e302 - 1) < 4 * kUnit);
  CHECK(hunt_crossley_restitution(contact(1e200), 1e200) == 0);
  CHECK(std::abs(hunt_crossley_restitution(contact(1e290), 1e30) / 1e-320 - 1) < 1e-3);
  CHECK(std::abs(contact::hunt_crossley_depth(contact(1e200), 1.0, 1e200) - std::sqrt(2.0)) <
        1e-14);
  const HuntCrossley<double> balls{1, 1e200, ContactExponent::hertz};
  const double depth = contact::hunt_crossley_depth(balls, 1.0, 1e200);
  CHECK(std::abs(depth * depth * std::sqrt(depth) - 2.5) < 1e-13);
}

TEST_CASE("a slow impact has e = 1 − 2/3 λ v + 4/9 (λ v)² − …, a fast one leaves with 1/λ") {
  for (const double p : {1e-12, 1e-6, 1e-3, 0.01, 0.05}) {
    const double e =
        hunt_crossley_restitution(HuntCrossley<double>{1, p, ContactExponent::linear}, 1.0);
    CHECK(std::abs(e - (1 - 2 * p / 3)) <= 4 * p * p / 9 + 2 * kUnit);
    CHECK(std::abs(e - (1 - 2 * p / 3 + 4 * p * p / 9)) <= 0.4 * p * p * p + 2 * kUnit);
  }
  const HuntCrossley<double> contact{1, 0.5, ContactExponent::linear};
  double before = 0;
  for (double v = 1; v < 1e6; v *= 2) {
    const double leaving = hunt_crossley_restitution(contact, v) * v;
    CHECK(leaving >= before);
    CHECK(leaving <= 2);
    before = leaving;
  }
  CHECK(std::abs(before - 2) < 1e-12);
}

TEST_CASE("the restitution falls with the speed") {
  const HuntCrossley<double> contact{1, 1, ContactExponent::linear};
  double before = 1;
  for (int i = 1; i < 4000; ++i) {
    const double e = hunt_crossley_restitution(contact, i / 256.0);
    REQUIRE(e < before);
    before = e;
  }
}

TEMPLATE_TEST_CASE("the depth of an impact with dissipation", "", float, double) {
  using S = TestType;
  Random random(1692);
  const Rational room = 40 * oracle::exact(kUnit) +
                        Rational(1001, 1000) * oracle::exact(contact::tolerance::unit_roundoff<S>);
  for (int i = 0; i < generators::tried(800); ++i) {
    const S k = S(std::abs(random.magnitude(-15, 15)));
    const S m = S(std::abs(random.magnitude(-15, 15)));
    const S v = S(std::abs(random.magnitude(-10, 10)));
    const S lambda = S(std::abs(random.magnitude(-30, 12)));
    const Rational p = oracle::exact(lambda) * oracle::exact(v);
    const Rational mass_by_k = oracle::exact(m) / oracle::exact(k);
    const Rational square = oracle::exact(lambda) * oracle::exact(lambda);
    const Interval energy = compression(p) * lift(Rational(mass_by_k / square));
    const auto depth = [&](ContactExponent n) {
      return oracle::exact(contact::hunt_crossley_depth(hunt_crossley(k, lambda, n), m, v));
    };
    const auto fits = [&](const Rational& d, int n, const Interval& x) {
      Rational low = 1;
      Rational high = 1;
      for (int j = 0; j < n; ++j) {
        low *= d * (1 - room);
        high *= d * (1 + room);
      }
      return low <= x.high() && x.low() <= high;
    };
    REQUIRE(fits(depth(ContactExponent::linear), 2, energy * lift(2)));
    const Interval more = energy * lift(Rational(5, 2));
    REQUIRE(fits(depth(ContactExponent::hertz), 5, more * more));
  }
  const HuntCrossley<S> none{S(3), S(0), ContactExponent::hertz};
  const auto hertz = contact::hertz_impact(contact::hertz_contact(S(3)), S(2), S(1));
  CHECK(std::abs(contact::hunt_crossley_depth(none, S(2), S(1)) - hertz.max_depth) <=
        S(40 * kUnit) + contact::tolerance::unit_roundoff<S>);
  CHECK(contact::hunt_crossley_depth(none, S(2), S(0)) == S(0));
}

TEST_CASE("steps of the equation of motion agree, and never pull without another force") {
  for (const ContactExponent n : {ContactExponent::linear, ContactExponent::hertz}) {
    for (const double lambda : {0.0, 0.05, 0.3, 1.0, 4.0}) {
      const HuntCrossley<double> contact{100, lambda, n};
      contact::PenaltyState<double> state{0, 3};
      double deepest = 0;
      bool pulled = false;
      const double h = 1e-5;
      while (state.penetration >= 0) {
        state = contact::staged_step(
            contact::PenaltyScheme::runge_kutta_4, state, h,
            [&](double x, double v) { return -contact::hunt_crossley_force(contact, x, v) / 2; });
        deepest = std::max(deepest, state.penetration);
        pulled = pulled || contact::would_pull(contact, state.approach);
      }
      CHECK(!pulled);
      CHECK(std::abs(-state.approach / 3 - hunt_crossley_restitution(contact, 3.0)) < 1e-6);
      CHECK(std::abs(deepest - contact::hunt_crossley_depth(contact, 2.0, 3.0)) < 1e-6);
    }
  }
}

TEST_CASE("a force that pulls the bodies apart makes them separate faster than 1/λ") {
  // Then 1 + λ δ̇ is negative, and the force is 0 instead of a pull.
  const HuntCrossley<double> contact{100, 1, ContactExponent::hertz};
  contact::PenaltyState<double> state{0, 3};
  int pulled = 0;
  while (state.penetration >= 0) {
    state = contact::staged_step(contact::PenaltyScheme::runge_kutta_4, state, 1e-4,
                                 [&](double x, double v) {
                                   const double force = contact::hunt_crossley_force(contact, x, v);
                                   return -force / 2 - 40;
                                 });
    pulled += contact::would_pull(contact, state.approach);
  }
  CHECK(pulled > 0);
  CHECK(state.approach < -1);
}

TEMPLATE_TEST_CASE("the force of Hunt and Crossley, and whether it would pull", "", float, double) {
  using S = TestType;
  Random random(1693);
  const Rational u = oracle::exact(contact::tolerance::unit_roundoff<S>);
  int pulls = 0;
  int close = 0;
  for (int i = 0; i < generators::tried(3000); ++i) {
    const S lambda = S(std::abs(random.magnitude(-6, 3)));
    const auto linear =
        hunt_crossley(S(std::abs(random.magnitude(-10, 10))), lambda, ContactExponent::linear);
    const auto hertz = hunt_crossley(linear.stiffness, lambda);
    S v = S(random.magnitude(-6, 6));
    if (i % 3 == 0) v = S(-1) / lambda;  // to the last bit where it pulls
    const S d = S(random.magnitude(-10, 2));
    const Rational share = 1 + oracle::exact(lambda) * oracle::exact(v);
    REQUIRE(contact::would_pull(linear, v) == (share < 0));
    pulls += share < 0;
    close += share != 0 && abs(share) < 4 * u;
    const S force = contact::hunt_crossley_force(linear, d, v);
    REQUIRE(force >= S(0));
    if (d < S(0)) {
      REQUIRE(force == S(0));
      REQUIRE(contact::hunt_crossley_force(hertz, d, v) == S(0));
      continue;
    }
    const Rational spring = oracle::exact(linear.stiffness) * oracle::exact(d);
    const Rational right = share < 0 ? Rational(0) : Rational(spring * share);
    const Rational size = 1 + oracle::exact(lambda) * abs(oracle::exact(v));
    REQUIRE(abs(oracle::exact(force) - right) <= 7 * u * spring * size);
    // The power 3/2: the force is √δ times as much, squared to compare.
    const Rational more = oracle::exact(contact::hunt_crossley_force(hertz, d, v));
    const Rational high = right + 7 * u * spring * size;
    const Rational low = std::max(Rational(0), Rational(right - 7 * u * spring * size));
    REQUIRE(more * more <= high * high * oracle::exact(d));
    REQUIRE(more * more >= low * low * oracle::exact(d));
  }
  CHECK(pulls > generators::tried(500));
  CHECK(close > generators::tried(100));
  const S inf = std::numeric_limits<S>::infinity();
  CHECK(!contact::would_pull(HuntCrossley<S>{S(1), S(1), ContactExponent::hertz}, -inf));
}

TEMPLATE_TEST_CASE("the dissipation for a restitution gives it back", "", float, double) {
  using S = TestType;
  Random random(1694);
  const double room = 100 * kUnit + 2 * double(contact::tolerance::unit_roundoff<S>);
  for (int i = 0; i < generators::tried(1000); ++i) {
    const S e = S(i % 4 == 0 ? 1 - std::ldexp(random.uniform(0.5, 1), -random.integer(0, 20))
                             : random.uniform(0.01, 1));
    const S v = S(std::abs(random.magnitude(-20, 20)));
    const S lambda = contact::dissipation_for(e, v);
    const S back = hunt_crossley_restitution(hunt_crossley(S(1), lambda), v);
    REQUIRE(std::abs(double(back) - double(e)) <= room);
  }
  CHECK(contact::dissipation_for(S(1), S(3)) == S(0));
}

TEST_CASE("an invalid contact of Hunt and Crossley is refused") {
  const double inf = std::numeric_limits<double>::infinity();
  CHECK(contains(refusal([] { hunt_crossley(0.0, 1.0); }), "stiffness = 0"));
  CHECK(contains(refusal([] { hunt_crossley(1.0, -1.0); }), "dissipation = -1"));
  CHECK(contains(refusal([&] { hunt_crossley(1.0, inf); }), "dissipation"));
  CHECK(contains(refusal([] { contact::dissipation_for(0.0, 1.0); }), "restitution = 0"));
  CHECK(contains(refusal([] { contact::dissipation_for(1.1, 1.0); }), "restitution"));
  CHECK(contains(refusal([] { contact::dissipation_for(0.5, 0.0); }), "speed = 0"));
}

}  // namespace
}  // namespace hunt_crossley_test
