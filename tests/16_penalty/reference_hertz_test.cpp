// Hertz's contact: roots, depth and force by powers of fractions (class (a) of the oracle), the
// duration by MPFR's beta function and the motion by its series in intervals (class (c)), and both
// against steps of the equation of motion.
#include <mpfr.h>

#include <array>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/hertz.hpp>
#include <contact/penalty_step.hpp>
#include <contact/tolerance.hpp>
#include <limits>

#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/refusal.hpp"

namespace hertz_test {
namespace {

using contact::elastic_solid;
using contact::hertz_at;
using contact::hertz_contact;
using contact::hertz_impact;
using contact::HertzContact;
using generators::Random;
using oracle::Interval;
using oracle::Rational;
using support::contains;
using support::refusal;

constexpr double kUnit = 0x1p-53;
constexpr unsigned kBits = 256;

Rational power(const Rational& x, int n) {
  Rational result = 1;
  for (int i = 0; i < n; ++i) result *= x;
  return result;
}

/// Whether got is within `room` times the n-th root of x, for positive numbers.
bool is_root(double got, const Rational& x, int n, const Rational& room) {
  const Rational exact = oracle::exact(got);
  return power(exact * (1 - room), n) <= x && x <= power(exact * (1 + room), n);
}

/// 4/5 B(2/5, 1/2) by MPFR, between two fractions.
Interval duration_factor() {
  mpfr_t a;
  mpfr_t b;
  mpfr_inits2(320, a, b, static_cast<mpfr_ptr>(nullptr));
  mpfr_set_ui(a, 2, MPFR_RNDN);
  mpfr_div_ui(a, a, 5, MPFR_RNDN);
  mpfr_set_d(b, 0.5, MPFR_RNDN);
  mpfr_beta(a, a, b, MPFR_RNDN);
  mpfr_mul_ui(a, a, 4, MPFR_RNDN);
  mpfr_div_ui(a, a, 5, MPFR_RNDN);
  mpq_t fraction;
  mpq_init(fraction);
  mpfr_get_q(fraction, a);
  const Rational value(fraction);
  mpq_clear(fraction);
  mpfr_clears(a, b, static_cast<mpfr_ptr>(nullptr));
  const Rational room = power(Rational(1, 2), 300);
  return {value - room, value + room, kBits};
}

/// Σ cₙ xⁿ / (first + n step) with cₙ / cₙ₋₁ = (n − less) / n: the two integrals, for x to 0.6.
Interval series(const Interval& x, const Rational& less, const Rational& first,
                const Rational& step) {
  Interval term(Rational(1), kBits);
  Interval sum(Rational(1) / first, kBits);
  for (int n = 1; n < 400; ++n) {
    term = term * x * Interval((Rational(n) - less) / n, kBits);
    sum = sum + term * Interval(Rational(1) / (first + n * step), kBits);
  }
  return sum;  // what is left out is below 0.6^400
}

/// The time to the depth x, up to y = x^(5/2) = 0.6.
Interval time_to_depth(const Rational& x) {
  const Interval depth(x, kBits);
  return depth * series(depth * depth * sqrt(depth), Rational(1, 2), 1, Rational(5, 2));
}

/// The time from the speed w to the greatest depth.
Interval time_from_speed(const Rational& w) {
  return Interval(Rational(Rational(4, 5) * w), kBits) *
         series(Interval(Rational(w * w), kBits), Rational(2, 5), 1, 2);
}

TEST_CASE("third and fifth roots have a relative error of at most 3 u") {
  Random random(1681);
  for (int i = 0; i < generators::tried(4000); ++i) {
    const double x =
        i % 2 == 0 ? std::abs(generators::any_finite(random)) : std::abs(random.magnitude(-8, 8));
    if (x == 0) continue;
    INFO(x);
    REQUIRE(is_root(contact::detail::root_of(x, 5), oracle::exact(x), 5, 3 * oracle::exact(kUnit)));
    REQUIRE(is_root(contact::detail::root_of(x, 3), oracle::exact(x), 3, 3 * oracle::exact(kUnit)));
  }
  CHECK(contact::detail::root_of(32.0, 5) == 2);
  CHECK(contact::detail::root_of(0.125, 3) == 0.5);
  CHECK(is_root(contact::detail::hertz_half_depth, Rational(1, 4), 5, oracle::exact(kUnit)));
  CHECK(is_root(contact::detail::root_of_half, Rational(1, 2), 2, oracle::exact(kUnit)));
}

TEST_CASE("the duration factor is 4/5 B(2/5, 1/2)") {
  const Interval right = duration_factor();
  const Rational got = oracle::exact(contact::hertz_duration_factor());
  CHECK(abs(got - right.low()) <= 20 * oracle::exact(kUnit) * right.low());
  CHECK(contact::hertz_duration_factor() > 2.943275);
  CHECK(contact::hertz_duration_factor() < 2.943276);
}

TEMPLATE_TEST_CASE("depth, force and duration of Hertz's impact", "", float, double) {
  using S = TestType;
  Random random(1682);
  const Interval factor = duration_factor();
  const Rational u = oracle::exact(contact::tolerance::unit_roundoff<S>);
  const Rational room = 40 * oracle::exact(kUnit) + Rational(1001, 1000) * u;
  const auto is_normal = [](double x) {
    return x > double(std::numeric_limits<S>::min()) && x < double(std::numeric_limits<S>::max());
  };
  int tested = 0;
  for (int i = 0; i < generators::tried(600); ++i) {
    const auto any = [&] {  // every magnitude, or one in the middle
      const int range = sizeof(S) == sizeof(float) ? 20 : 200;
      const S x =
          i % 2 == 0 ? generators::any_finite<S>(random) : S(random.magnitude(-range, range));
      return x == S(0) ? S(1) : S(std::abs(x));
    };
    const S m = any();
    const S k = any();
    const S v = any();
    const auto impact = hertz_impact(hertz_contact(k), m, v);
    REQUIRE(impact.max_depth >= S(0));
    REQUIRE(impact.duration >= S(0));
    REQUIRE(impact.max_force >= S(0));
    const Rational energy = Rational(5, 4) * oracle::exact(m) * oracle::exact(v) * oracle::exact(v);
    const Rational kappa = oracle::exact(k);
    INFO(m << " " << k << " " << v);
    if (is_normal(double(impact.max_depth))) {
      ++tested;
      REQUIRE(is_root(double(impact.max_depth), power(energy / kappa, 2), 5, room));
    }
    if (is_normal(double(impact.max_force))) {
      ++tested;
      REQUIRE(is_root(double(impact.max_force), kappa * kappa * power(energy, 3), 5, room));
    }
    if (is_normal(double(impact.duration))) {
      ++tested;
      const Rational in_depths = oracle::exact(impact.duration) * oracle::exact(v) / factor.low();
      const Rational fifth = power(energy / kappa, 2);
      REQUIRE(power(in_depths * (1 - room), 5) <= fifth);
      REQUIRE(fifth <= power(in_depths * (1 + room), 5));
    }
  }
  CHECK(tested > generators::tried(1200));
}

TEST_CASE("Hertz's impact at scales from 1e-150 to 1e150 has a finite depth") {
  for (const double m : {1e-150, 1.0, 1e150}) {
    for (const double k : {1e-150, 1.0, 1e150}) {
      for (const double v : {1e-150, 1.0, 1e150}) {
        const auto impact = hertz_impact(hertz_contact(k), m, v);
        const Rational energy = Rational(5, 4) * oracle::exact(m) * oracle::exact(v) *
                                oracle::exact(v) / oracle::exact(k);
        REQUIRE(is_root(impact.max_depth, energy * energy, 5, 40 * oracle::exact(kUnit)));
      }
    }
  }
  const double least = std::numeric_limits<double>::denorm_min();
  CHECK(hertz_impact(hertz_contact(least), least, 1.0).max_depth > 1);
  CHECK(hertz_impact(hertz_contact(1.0), 1.0, 0.0).max_depth == 0);
  CHECK(std::isinf(hertz_impact(hertz_contact(1.0), 1.0, 0.0).duration));
}

TEST_CASE("a faster Hertz impact is shorter, as v to the power −1/5") {
  const auto contact = hertz_contact(1000.0);
  const auto slow = hertz_impact(contact, 1.0, 1.0);
  const auto fast = hertz_impact(contact, 1.0, 32.0);
  CHECK(std::abs(slow.duration / fast.duration - 2) < 1e-13);
  CHECK(std::abs(fast.max_depth / slow.max_depth - 16) < 1e-12);
}

TEST_CASE("Hertz's motion over time is that of its series") {
  // With m = v = 1 and κ = 5/4 depth and speed have the unit 1.
  const auto contact = hertz_contact(1.25);
  const Interval half = duration_factor() * Interval(Rational(1, 2), kBits);
  const Rational room = 60 * oracle::exact(kUnit);
  Random random(1683);
  int near_top = 0;
  for (int i = 0; i < generators::tried(160); ++i) {
    const double time =
        i % 4 == 0 ? std::abs(random.magnitude(-40, -1)) : random.uniform(0, 1.4716);
    const auto moment = hertz_at(contact, 1.0, 1.0, time);
    REQUIRE(moment.touching);
    const Rational x = oracle::exact(moment.state.penetration);
    const Rational w = oracle::exact(moment.state.approach);
    const Rational t = oracle::exact(time);
    INFO(time);
    REQUIRE(w >= 0);
    if (w * w > Rational(1, 2)) {
      REQUIRE(time_to_depth(x - std::min(room, x)).low() <= t);
      REQUIRE(t <= time_to_depth(x + room).high());
      // The energy gives the speed: w² = 1 − x^(5/2).
      const Interval depth(x, kBits);
      const Interval rest = Interval(Rational(1), kBits) - depth * depth * sqrt(depth);
      REQUIRE(abs(w - sqrt(rest).low()) <= room);
    } else {
      ++near_top;
      const Interval left = half - Interval(t, kBits);
      REQUIRE(time_from_speed(w - std::min(room, w)).low() <= left.high());
      REQUIRE(left.low() <= time_from_speed(w + room).high());
      REQUIRE(is_root(moment.state.penetration, power(1 - w * w, 2), 5, 2 * room));
    }
  }
  CHECK(near_top > generators::tried(24));
}

TEST_CASE("the second half of Hertz's impact is the first in reverse, and then the body flies") {
  const auto contact = hertz_contact(500.0);
  const auto impact = hertz_impact(contact, 2.0, 3.0);
  for (int n = 0; n <= 32; ++n) {
    const double t = impact.duration * n / 64;
    const auto first = hertz_at(contact, 2.0, 3.0, t);
    const auto last = hertz_at(contact, 2.0, 3.0, impact.duration - t);
    CHECK(std::abs(first.state.penetration - last.state.penetration) < 1e-14);
    CHECK(std::abs(first.state.approach + last.state.approach) < 1e-13);
    CHECK(first.force <= impact.max_force * (1 + 1e-14));
  }
  const auto after = hertz_at(contact, 2.0, 3.0, impact.duration + 1);
  CHECK(!after.touching);
  CHECK(after.force == 0);
  CHECK(after.state.approach == -3);
  CHECK(std::abs(after.state.penetration + 3) < 1e-14);
}

TEST_CASE("Hertz's motion agrees with Runge–Kutta steps, and its impulse is 2 m v") {
  const auto contact = hertz_contact(500.0);
  const auto impact = hertz_impact(contact, 2.0, 3.0);
  constexpr int steps = 20000;
  const double h = impact.duration / steps;
  contact::PenaltyState<double> state{0, 3};
  double impulse = 0;
  for (int n = 0; n < steps; ++n) {
    const auto moment = hertz_at(contact, 2.0, 3.0, n * h);
    REQUIRE(std::abs(state.penetration - moment.state.penetration) < 1e-8);
    REQUIRE(std::abs(state.approach - moment.state.approach) < 1e-7);
    impulse += moment.force * h;
    state = contact::staged_step(
        contact::PenaltyScheme::runge_kutta_4, state, h,
        [&](double x, double) { return -contact::hertz_force(contact, x) / 2; });
  }
  CHECK(std::abs(impulse - 12) < 1e-6);
}

TEMPLATE_TEST_CASE("force, energy and depth under a load of Hertz's contact", "", float, double) {
  using S = TestType;
  Random random(1684);
  const Rational u = oracle::exact(contact::tolerance::unit_roundoff<S>);
  for (int i = 0; i < generators::tried(2000); ++i) {
    const S k = S(std::abs(random.magnitude(-20, 20)));
    const S d = S(random.magnitude(-20, 5));
    const auto contact = hertz_contact(k);
    const S force = contact::hertz_force(contact, d);
    const S energy = contact::hertz_energy(contact, d);
    if (d < S(0)) {
      REQUIRE(force == S(0));
      REQUIRE(energy == S(0));
      continue;
    }
    const Rational kappa = oracle::exact(k);
    const Rational depth = oracle::exact(d);
    REQUIRE(is_root(double(force), kappa * kappa * power(depth, 3), 2, 3 * u));
    REQUIRE(is_root(double(energy), Rational(4, 25) * kappa * kappa * power(depth, 5), 2, 6 * u));
    const S back = contact::hertz_depth_under(contact, force);
    const Rational ratio = oracle::exact(force) / kappa;
    REQUIRE(is_root(double(back), ratio * ratio, 3, 9 * u));
  }
  CHECK(contact::hertz_depth_under(hertz_contact(S(1)), S(0)) == S(0));
}

TEMPLATE_TEST_CASE("the stiffness of elastic balls", "", float, double) {
  using S = TestType;
  Random random(1685);
  const Rational u = oracle::exact(contact::tolerance::unit_roundoff<S>);
  for (int i = 0; i < generators::tried(1000); ++i) {
    const S ball_modulus = S(random.uniform(1e6, 1e11));
    const S ball_ratio = S(random.uniform(-0.9, 0.5));
    const auto ball = elastic_solid(ball_modulus, ball_ratio);
    const S ground_modulus = S(random.uniform(1e6, 1e11));
    const S ground_ratio = S(random.uniform(-0.9, 0.5));
    const auto ground = elastic_solid(ground_modulus, ground_ratio);
    const S r = S(random.uniform(0.001, 1));
    const S other = S(random.uniform(0.001, 1));
    const auto softness = [](const auto& solid) {
      const Rational nu = oracle::exact(solid.poisson);
      return Rational((1 - nu * nu) / oracle::exact(solid.modulus));
    };
    const Rational modulus = 1 / (softness(ball) + softness(ground));
    const Rational square = Rational(16, 9) * modulus * modulus;
    REQUIRE(is_root(double(hertz_contact(r, ball, ground).stiffness), square * oracle::exact(r), 2,
                    12 * u));
    const Rational both =
        oracle::exact(r) * oracle::exact(other) / (oracle::exact(r) + oracle::exact(other));
    REQUIRE(
        is_root(double(hertz_contact(r, ball, other, ground).stiffness), square * both, 2, 16 * u));
  }
}

TEST_CASE("an invalid Hertz contact or material is refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(contains(refusal([] { hertz_contact(0.0); }), "stiffness = 0"));
  CHECK(contains(refusal([&] { hertz_contact(nan); }), "stiffness"));
  CHECK(contains(refusal([] { elastic_solid(0.0, 0.3); }), "modulus = 0"));
  CHECK(contains(refusal([] { elastic_solid(1.0, 0.51); }), "poisson"));
  CHECK(contains(refusal([] { elastic_solid(1.0, -1.0); }), "poisson"));
  const auto steel = elastic_solid(2e11, 0.3);
  CHECK(contains(refusal([&] { hertz_contact(0.0, steel, steel); }), "radius"));
  CHECK(contains(refusal([&] { hertz_contact(1.0, steel, 0.0, steel); }), "second_radius"));
}

}  // namespace
}  // namespace hertz_test
