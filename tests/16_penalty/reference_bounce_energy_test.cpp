// Energy of a bounce in steps: bounds that fractions follow step by step (class (a) of the oracle),
// also beyond the stability limit.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/bounce_energy.hpp>
#include <string>
#include <vector>

#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/refusal.hpp"

namespace bounce_energy_test {
namespace {

using contact::bounce_energy_factor;
using contact::mean_bounce_energy_factor;
using contact::PenaltyScheme;
using contact::PenaltyState;
using contact::SpringDamper;
using generators::Random;
using oracle::Rational;

/// The ratio of speeds of a bounce with mass 1 and step 1 from the first overlap σ, speed 1; and
/// the number of steps with a force.
struct Bounce {
  Rational ratio;
  int steps = 0;

  Bounce(const Rational& a, const Rational& sigma) {
    PenaltyState<Rational> state{sigma, 1};
    while (state.penetration >= 0) {
      state = contact::penalty_step<Rational>(PenaltyScheme::semi_implicit_euler, state, {a, 0}, 1,
                                              1, 0);
      ++steps;
    }
    ratio = -state.approach;
  }
};

TEST_CASE("a bounce in coarse steps has a force in at most two, and its bounds are reached") {
  Random random(1651);
  for (int i = 0; i < generators::tried(1000); ++i) {
    const Rational a = 2 + Rational(random.integer(0, 4000), 200);
    const auto bound = bounce_energy_factor<Rational>({a, 0}, 1, 1);
    const Bounce bounce(a, Rational(random.integer(0, 1023), 1024));
    REQUIRE(bounce.steps <= 2);
    REQUIRE(bounce.ratio > 0);
    REQUIRE(bounce.ratio * bounce.ratio >= bound.min);
    REQUIRE(bounce.ratio * bounce.ratio <= bound.max);
    const Bounce gain(a, 0);
    REQUIRE(gain.ratio * gain.ratio == bound.max);
    if (a == 2) continue;
    const Bounce loss(a, Rational(1 / (a - 1)));
    REQUIRE(loss.ratio * loss.ratio == bound.min);
  }
}

TEST_CASE("the bounds of a bounce also hold for short steps, and for other masses and steps") {
  Random random(1652);
  for (int i = 0; i < generators::tried(1000); ++i) {
    const Rational a(random.integer(8, 511), 256);
    const auto bound = bounce_energy_factor<Rational>({a, 0}, 1, 1);
    const Bounce bounce(a, Rational(random.integer(0, 255), 256));
    REQUIRE(bounce.ratio * bounce.ratio >= bound.min);
    REQUIRE(bounce.ratio * bounce.ratio <= bound.max);
    const Rational m(random.integer(1, 99), 7);
    const Rational h(random.integer(1, 99), 11);
    const auto scaled = bounce_energy_factor<Rational>({a * m / (h * h), 0}, m, h);
    REQUIRE(scaled.min == bound.min);
    REQUIRE(scaled.max == bound.max);
  }
}

/// The means of R² and 1 / R² over first overlaps σ from 0 to 1. R is linear in σ between the
/// values at which the number of steps changes, which bisection finds; both integrals are exact for
/// a linear R.
struct Means {
  Rational square = 0;
  Rational inverse = 0;

  void add(const Rational& a, const Rational& low, const Rational& high) {
    // Within, by two points, so that neither end belongs to another piece.
    const Rational s = (3 * low + high) / 4;
    const Rational t = (low + 3 * high) / 4;
    const Rational at_s = Bounce(a, s).ratio;
    const Rational slope = (Bounce(a, t).ratio - at_s) / (t - s);
    const Rational first = at_s + slope * (low - s);
    const Rational last = at_s + slope * (high - s);
    square += (high - low) * (first * first + first * last + last * last) / 3;
    inverse += (high - low) / (first * last);
  }
};

/// The σ at which the overlap after some steps of a body that stays attached is 0: there one more
/// step has a force or not.
std::vector<Rational> borders(const Rational& a) {
  std::vector<Rational> found{0, 1};
  PenaltyState<Rational> zero{0, 1};
  PenaltyState<Rational> one{1, 1};
  for (int n = 0; n < 60; ++n) {
    zero =
        contact::spring_step<Rational>(PenaltyScheme::semi_implicit_euler, zero, {a, 0}, 1, 1, 0);
    one = contact::spring_step<Rational>(PenaltyScheme::semi_implicit_euler, one, {a, 0}, 1, 1, 0);
    if (zero.penetration == one.penetration) continue;
    const Rational sigma = zero.penetration / (zero.penetration - one.penetration);
    if (sigma > 0 && sigma < 1) found.push_back(sigma);
    if (zero.penetration < 0 && one.penetration < 0) break;
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

Means means(const Rational& a) {
  const std::vector<Rational> border = borders(a);
  Means sum;
  for (std::size_t i = 1; i < border.size(); ++i) sum.add(a, border[i - 1], border[i]);
  return sum;
}

TEST_CASE("the mean of 1/R² of a bounce is exactly 1, so the mean of the energy does not fall") {
  Random random(1653);
  int gains = 0;
  for (int i = 0; i < generators::tried(200); ++i) {
    const Rational a(random.integer(4, 1600), 200);
    const Means mean = means(a);
    INFO(oracle::text(a));
    REQUIRE(mean.inverse == 1);
    REQUIRE(mean.square >= 1);
    gains += mean.square > 1;
    if (a < 2) continue;
    REQUIRE(mean.square == mean_bounce_energy_factor<Rational>({a, 0}, 1, 1));
  }
  CHECK(gains > generators::tried(150));
}

TEST_CASE(
    "at the stability limit a bounce multiplies the energy by up to 9, by 91/27 in the mean") {
  const SpringDamper<Rational> spring{4, 0};
  CHECK(bounce_energy_factor<Rational>(spring, 1, 1).max == 9);
  CHECK(bounce_energy_factor<Rational>(spring, 1, 1).min == Rational(1, 9));
  CHECK(mean_bounce_energy_factor<Rational>(spring, 1, 1) == Rational(91, 27));
  CHECK(mean_bounce_energy_factor<Rational>({2, 0}, 1, 1) == 1);
  const std::string said = support::refusal([] {
    mean_bounce_energy_factor<double>(SpringDamper<double>{1.9, 0}, 1.0, 1.0);
  });
  CHECK(support::contains(said, "h = 1"));
}

TEST_CASE("both forms of Verlet's step bounce within the same bounds, and reach them") {
  Random random(1654);
  int gains = 0;
  for (int i = 0; i < generators::tried(1000); ++i) {
    const Rational a(random.integer(8, 2000), 256);
    const auto bound = bounce_energy_factor<Rational>({a, 0}, 1, 1);
    const Rational gap(random.integer(1, 1024), 1024);
    for (const PenaltyScheme scheme :
         {PenaltyScheme::velocity_verlet, PenaltyScheme::position_verlet}) {
      PenaltyState<Rational> state{-gap - 1, 1};
      int flying = 0;
      for (int n = 0; n < 200 && flying < 2; ++n) {
        state = contact::penalty_step<Rational>(scheme, state, {a, 0}, 1, 1, 0);
        flying = state.approach < 0 && state.penetration < 0 ? flying + 1 : 0;
      }
      REQUIRE(flying == 2);
      REQUIRE(state.approach * state.approach >= bound.min);
      REQUIRE(state.approach * state.approach <= bound.max);
      gains += state.approach * state.approach > bound.max * Rational(9, 10);
    }
  }
  CHECK(gains > generators::tried(40));
}

TEST_CASE("a bounce of explicit Euler's steps is not a power of the area factor") {
  const auto spring = contact::spring_damper(3.61, 0.0);  // a = 1.9²
  contact::PenaltyState<double> state{0.5, 1};
  while (state.penetration >= 0)
    state = contact::penalty_step(PenaltyScheme::explicit_euler, state, spring, 1.0, 1.0, 0.0);
  const double energy = state.approach * state.approach;
  const double factor = contact::step_area_factor(PenaltyScheme::explicit_euler, spring, 1.0, 1.0);
  CHECK(energy > 3 * factor * factor);
  CHECK(energy < 0.9 * factor * factor * factor);
}

TEST_CASE("without a damper three schemes multiply the energy by the area factor, exactly") {
  Random random(1655);
  for (int i = 0; i < generators::tried(500); ++i) {
    const Rational k(random.integer(1, 99), 7);
    const Rational m(random.integer(1, 99), 5);
    const Rational h(random.integer(1, 40), 10);
    const Rational a = h * h * k / m;
    const PenaltyState<Rational> now{Rational(random.integer(-20, 20), 3), 2};
    const auto factor = [&](PenaltyScheme scheme) {
      return contact::step_area_factor<Rational>(scheme, {k, 0}, m, h);
    };
    const auto energy = [&](const PenaltyState<Rational>& x) {
      return Rational(m * x.approach * x.approach + k * x.penetration * x.penetration);
    };
    for (const PenaltyScheme scheme : {PenaltyScheme::explicit_euler, PenaltyScheme::implicit_euler,
                                       PenaltyScheme::runge_kutta_4}) {
      const auto next = contact::spring_step<Rational>(scheme, now, {k, 0}, m, h, 0);
      REQUIRE(energy(next) == factor(scheme) * energy(now));
    }
    REQUIRE(factor(PenaltyScheme::explicit_euler) == 1 + a);
    REQUIRE(factor(PenaltyScheme::implicit_euler) * (1 + a) == 1);
    REQUIRE(factor(PenaltyScheme::runge_kutta_4) == 1 - a * a * a / 72 + a * a * a * a / 576);
    for (const PenaltyScheme scheme :
         {PenaltyScheme::semi_implicit_euler, PenaltyScheme::velocity_verlet,
          PenaltyScheme::position_verlet}) {
      REQUIRE(factor(scheme) == 1);
    }
  }
}

}  // namespace
}  // namespace bounce_energy_test
