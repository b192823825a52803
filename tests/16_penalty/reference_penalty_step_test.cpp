// Steps on a contact spring: decisions and one-step maps in fractions (class (a) of the oracle),
// limits with one square root (class (b)), energy bounds by fractions that follow every step.
#include <algorithm>
#include <array>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/penalty_step.hpp>
#include <contact/spring_impact.hpp>
#include <contact/tolerance.hpp>
#include <limits>

#include "support/generators.hpp"
#include "support/oracle.hpp"

namespace penalty_step_test {

using contact::ContactRelease;
using contact::PenaltyScheme;
using contact::PenaltyState;
using contact::SpringDamper;
using contact::StepBehaviour;
using generators::Random;
using oracle::Rational;
using oracle::Surd;

namespace {

constexpr std::array<PenaltyScheme, 4> kSchemes{
    PenaltyScheme::explicit_euler, PenaltyScheme::semi_implicit_euler,
    PenaltyScheme::implicit_damper, PenaltyScheme::implicit_euler};

/// The matrix of a step, by its columns.
struct StepMatrix {
  Rational a, b, c, d;

  StepMatrix(PenaltyScheme scheme, const SpringDamper<Rational>& spring, const Rational& m,
             const Rational& h) {
    const auto first = contact::spring_step<Rational>(scheme, {1, 0}, spring, m, h, 0);
    const auto second = contact::spring_step<Rational>(scheme, {0, 1}, spring, m, h, 0);
    a = first.penetration;
    b = second.penetration;
    c = first.approach;
    d = second.approach;
  }

  /// Whether the roots of x² − T x + D are inside the unit circle, on it, or outside, from the
  /// roots. A complex pair has |x|² = D; real roots are compared with ±1 as numbers with a square
  /// root.
  StepBehaviour behaviour() const {
    const Rational trace = a + d;
    const Rational product = a * d - b * c;
    const Rational discriminant = trace * trace - 4 * product;
    if (discriminant < 0) {
      if (product == 1) return StepBehaviour::bounded;
      return product < 1 ? StepBehaviour::decays : StepBehaviour::grows;
    }
    const Surd high{trace / 2, Rational(1, 2), discriminant};
    const Surd low{trace / 2, Rational(-1, 2), discriminant};
    const int top = oracle::compare(high, {1, 0, 0});
    const int bottom = oracle::compare(low, {-1, 0, 0});
    if (top > 0 || bottom < 0) return StepBehaviour::grows;
    if (top < 0 && bottom > 0) return StepBehaviour::decays;
    // A double root on the circle of a matrix that is not a multiple of the identity: it grows.
    return discriminant == 0 && (b != 0 || c != 0) ? StepBehaviour::grows : StepBehaviour::bounded;
  }
};

template <class S>
SpringDamper<Rational> lifted(const SpringDamper<S>& spring) {
  return {oracle::exact(spring.stiffness), oracle::exact(spring.damping)};
}

/// Springs, masses and steps, many of them exactly on a limit.
template <class S>
struct Sample {
  SpringDamper<S> spring;
  S mass, step;

  Sample(Random& random, int i) {
    if (i % 2 == 0) {
      // Small integers times powers of two give many ties.
      const int k = random.integer(1, 16);
      const int c = random.integer(0, 12);
      const int m = random.integer(1, 6);
      spring = contact::spring_damper(S(k), S(c));
      mass = S(m);
      step = S(std::ldexp(random.integer(1, 4), random.integer(-2, 1)));
      return;
    }
    spring =
        contact::spring_damper(S(std::abs(random.magnitude(-10, 10))),
                               S(random.chance(0.2) ? 0 : std::abs(random.magnitude(-10, 10))));
    mass = S(std::abs(random.magnitude(-10, 10)));
    const auto scheme = kSchemes[static_cast<std::size_t>(random.integer(0, 2))];
    step = contact::step_limit(scheme, spring, mass);
    if (!(step > S(0)) || i % 4 == 1) step = S(std::abs(random.magnitude(-10, 10)));
    for (int n = random.integer(0, 2); n > 0; --n)
      step = std::nextafter(step, S(random.chance(0.5) ? 0 : 1e9));
  }
};

}  // namespace

TEMPLATE_TEST_CASE("the stability of a step is decided exactly, for every scheme", "", float,
                   double) {
  using S = TestType;
  Random random(1621);
  std::array<std::array<int, 3>, 4> seen{};
  int borders = 0;
  for (int i = 0; i < generators::tried(12000); ++i) {
    const Sample<S> sample(random, i);
    for (std::size_t s = 0; s < kSchemes.size(); ++s) {
      const StepMatrix matrix(kSchemes[s], lifted(sample.spring), oracle::exact(sample.mass),
                              oracle::exact(sample.step));
      const StepBehaviour right = matrix.behaviour();
      REQUIRE(contact::step_behaviour(kSchemes[s], sample.spring, sample.mass, sample.step) ==
              right);
      ++seen[s][static_cast<std::size_t>(right)];
      borders += right == StepBehaviour::bounded && sample.spring.damping > S(0);
    }
  }
  for (std::size_t s = 0; s < 3; ++s) {
    for (const int count : seen[s]) CHECK(count > generators::tried(50));
  }
  CHECK(seen[3][0] == generators::tried(12000));  // implicit Euler always decays
  CHECK(borders > generators::tried(50));
}

TEST_CASE("if both inequalities are equalities it grows, though no root is outside the circle") {
  // a = b = 4 with explicit Euler; a = 4 and b = 0 with the two schemes after it.
  const auto grows = [](PenaltyScheme scheme, double c) {
    return contact::step_behaviour(scheme, contact::spring_damper(4.0, c), 1.0, 1.0) ==
           StepBehaviour::grows;
  };
  CHECK(grows(PenaltyScheme::explicit_euler, 4));
  CHECK(grows(PenaltyScheme::semi_implicit_euler, 0));
  CHECK(grows(PenaltyScheme::implicit_damper, 0));
  PenaltyState<Rational> state{1, 1};
  const SpringDamper<Rational> spring{4, 0};
  for (int i = 0; i < 1000; ++i)
    state =
        contact::spring_step<Rational>(PenaltyScheme::semi_implicit_euler, state, spring, 1, 1, 0);
  CHECK(abs(state.approach) > 1000);
}

TEST_CASE("the decided stability agrees with many steps") {
  // Computed in fractions with short denominators. A step that decays shrinks in the norm of its
  // eigenvectors; 4,000 steps show it wherever it is not too close to the limit.
  Random random(1622);
  int decayed = 0;
  int grown = 0;
  for (int i = 0; i < generators::tried(400); ++i) {
    const double k = random.integer(1, 32) / 8.0;
    const double c = random.integer(0, 32) / 8.0;
    const auto spring = contact::spring_damper(k, c);
    for (const PenaltyScheme scheme : kSchemes) {
      const StepBehaviour said = contact::step_behaviour(scheme, spring, 1.0, 1.0);
      PenaltyState<double> state{1, 0.25};
      double largest = 0;
      for (int n = 0; n < 4000; ++n) {
        state = contact::spring_step(scheme, state, spring, 1.0, 1.0, 0.0);
        if (!(std::abs(state.penetration) < 1e100)) break;
        if (n >= 3900) largest = std::max(largest, std::abs(state.penetration));
      }
      const bool left = !(std::abs(state.penetration) < 1e100);
      if (said == StepBehaviour::decays) {
        REQUIRE(!left);
        REQUIRE(largest < 1e-3);
        ++decayed;
      } else if (said == StepBehaviour::bounded) {
        REQUIRE(!left);
        REQUIRE(largest < 100);
      } else {
        REQUIRE((left || largest > 1000));
        ++grown;
      }
    }
  }
  CHECK(decayed > generators::tried(300));
  CHECK(grown > generators::tried(300));
}

TEMPLATE_TEST_CASE("the stability limit, against its square root and against the decision", "",
                   float, double) {
  using S = TestType;
  Random random(1623);
  const S u = contact::tolerance::unit_roundoff<S>;
  for (int i = 0; i < generators::tried(4000); ++i) {
    const Sample<S> sample(random, 2 * i + 1);
    const Rational k = oracle::exact(sample.spring.stiffness);
    const Rational c = oracle::exact(sample.spring.damping);
    const Rational m = oracle::exact(sample.mass);
    const Rational minus = c * c - 4 * k * m;
    const Rational plus = c * c + 4 * k * m;
    const std::array<Surd, 3> right{minus > 0 ? Surd{c / k, -1 / k, minus} : Surd{c / k, 0, 0},
                                    Surd{-c / k, 1 / k, plus}, Surd{c / k, 1 / k, plus}};
    for (std::size_t s = 0; s < 3; ++s) {
      const S limit = contact::step_limit(kSchemes[s], sample.spring, sample.mass);
      const double size = oracle::nearest(right[s]);
      REQUIRE(oracle::error(double(limit), right[s]) <= 8 * double(u) * size);
      if (!(limit > S(0))) {
        REQUIRE(sample.spring.damping == S(0));
        REQUIRE(s == 0);
        continue;
      }
      const S below = limit * (S(1) - S(16) * u);
      const S above = limit * (S(1) + S(16) * u);
      REQUIRE(contact::step_behaviour(kSchemes[s], sample.spring, sample.mass, below) !=
              StepBehaviour::grows);
      REQUIRE(contact::step_behaviour(kSchemes[s], sample.spring, sample.mass, above) ==
              StepBehaviour::grows);
    }
  }
  const auto spring = contact::spring_damper(S(3), S(0));
  CHECK(std::isinf(contact::step_limit(PenaltyScheme::implicit_euler, spring, S(1))));
  CHECK(contact::step_limit(PenaltyScheme::explicit_euler, spring, S(1)) == S(0));
}

TEST_CASE(
    "every step below the limit decays and every one beyond grows; the limit may be bounded") {
  const auto spring = contact::spring_damper(1.0, 1.0);
  const auto scheme = PenaltyScheme::explicit_euler;
  const double limit = contact::step_limit(scheme, spring, 1.0);
  REQUIRE(limit == 1);
  const auto behaviour = [&](double h) { return contact::step_behaviour(scheme, spring, 1.0, h); };
  CHECK(behaviour(std::nextafter(limit, 0)) == StepBehaviour::decays);
  CHECK(behaviour(limit) == StepBehaviour::bounded);
  CHECK(behaviour(std::nextafter(limit, 2)) == StepBehaviour::grows);
}

TEST_CASE("the energy that an impact in steps gains or loses is within its bounds") {
  Random random(1624);
  double nearest_least = 1;
  double nearest_most = 1;
  for (int i = 0; i < generators::tried(3000); ++i) {
    // Integers over small powers of two keep the fractions short.
    const Rational k(random.integer(1, 4095), 1024);  // a = k below 4
    const Rational v(random.integer(1, 64), 16);
    const Rational start = -v * Rational(random.integer(1, 256), 256);
    const SpringDamper<Rational> spring{k, 0};
    const auto bound = contact::stepped_energy_factor<Rational>(spring, 1, 1);
    PenaltyState<Rational> state{start, v};
    bool touched = false;
    Rational deepest = 0;
    for (int n = 0; n < 150 && (!touched || state.penetration >= 0); ++n) {
      state = contact::penalty_step<Rational>(PenaltyScheme::semi_implicit_euler, state, spring, 1,
                                              1, 0);
      touched = touched || state.penetration >= 0;
      deepest = std::max(deepest, state.penetration);
    }
    REQUIRE(state.penetration < 0);
    REQUIRE(state.approach < 0);
    const Rational factor = state.approach * state.approach / (v * v);
    REQUIRE(factor >= bound.min);
    REQUIRE(factor <= bound.max);
    REQUIRE(deepest * deepest * k * bound.min <= v * v);
    if (k > 1) {
      nearest_least = std::min(nearest_least,
                               oracle::nearest(Rational((factor - bound.min) / (1 - bound.min))));
      nearest_most =
          std::min(nearest_most, oracle::nearest(Rational((bound.max - factor) / (bound.max - 1))));
    }
  }
  // The bounds are sharp: some impacts come close to both.
  CHECK(nearest_least < 0.1);
  CHECK(nearest_most < 0.1);
}

TEST_CASE("with a = 1 every bounce keeps its energy, so longer steps than that of a bound may do") {
  const SpringDamper<Rational> spring{1, 0};
  for (int sigma = 0; sigma <= 64; ++sigma) {
    PenaltyState<Rational> state{Rational(sigma, 64), 1};  // the first overlap, in units of h v
    int steps = 0;
    for (; state.penetration >= 0; ++steps)
      state = contact::penalty_step<Rational>(PenaltyScheme::semi_implicit_euler, state, spring, 1,
                                              1, 0);
    REQUIRE(steps >= 2);
    REQUIRE(state.approach * state.approach == 1);
  }
  const double percent = contact::step_for_energy(contact::spring_damper(1.0, 0.0), 1.0, 0.01);
  CHECK(percent < 0.2);
}

TEMPLATE_TEST_CASE("the step for a required accuracy of the energy", "", float, double) {
  using S = TestType;
  Random random(1625);
  const double u = double(contact::tolerance::unit_roundoff<S>);
  for (int i = 0; i < generators::tried(3000); ++i) {
    const auto spring = contact::spring_damper(S(std::abs(random.magnitude(-20, 20))), S(0));
    const S m = S(std::abs(random.magnitude(-20, 20)));
    const S share = S(std::abs(random.magnitude(-20, 3)));
    const S h = contact::step_for_energy(spring, m, share);
    const Rational e = oracle::exact(share);
    const Rational square = 4 * e / (1 + e) * oracle::exact(m) / oracle::exact(spring.stiffness);
    REQUIRE(oracle::error(double(h), Surd{0, 1, square}) <= 6.01 * u * double(h));
    // With exactly this step the upper bound is 1 + ε: 1 / (1 − a/4) with a = 4 ε/(1+ε).
    const Rational a = square * oracle::exact(spring.stiffness) / oracle::exact(m);
    REQUIRE(1 / (1 - a / 4) == 1 + e);
    REQUIRE(1 - a / 4 >= 1 - e);
  }
}

TEST_CASE("a contact spring pulls in steps only with at_zero_penetration") {
  Random random(1626);
  int kept = 0;
  for (int i = 0; i < generators::tried(4000); ++i) {
    const Rational k(random.integer(1, 64), 16);
    const Rational c(random.integer(0, 64), 16);
    const Rational d(random.integer(-32, 32), 16);
    const Rational v(random.integer(-64, 64), 16);
    const Rational g(random.integer(0, 10));
    const Rational h(1, 1 << random.integer(0, 4));
    const SpringDamper<Rational> spring{k, c};
    for (const PenaltyScheme scheme : kSchemes) {
      const PenaltyState<Rational> now{d, v};
      const auto free =
          contact::penalty_step<Rational>(scheme, {Rational(-1000), v}, spring, 1, h, g);
      REQUIRE(free.approach == v + h * g);
      const auto next = contact::penalty_step<Rational>(scheme, now, spring, 1, h, g);
      REQUIRE(next.approach <= free.approach);
      const auto glued = contact::penalty_step<Rational>(scheme, now, spring, 1, h, g,
                                                         ContactRelease::at_zero_penetration);
      if (d < 0) {
        REQUIRE(next.approach == free.approach);
        REQUIRE(glued.approach == free.approach);
      } else {
        const auto joined = contact::spring_step<Rational>(scheme, now, spring, 1, h, g);
        REQUIRE(glued.approach == joined.approach);
        REQUIRE(glued.penetration == joined.penetration);
        kept += glued.approach > free.approach;
      }
      const bool old = scheme == PenaltyScheme::explicit_euler;
      REQUIRE(next.penetration == d + h * (old ? v : next.approach));
    }
  }
  CHECK(kept > generators::tried(500));
}

TEST_CASE("implicit forces are those of the end of the step, exactly") {
  Random random(1627);
  for (int i = 0; i < generators::tried(2000); ++i) {
    const Rational k{random.integer(1, 99), random.integer(1, 9)};
    const Rational c{random.integer(0, 99), random.integer(1, 9)};
    const Rational m{random.integer(1, 99), random.integer(1, 9)};
    const Rational d(random.integer(-99, 99), 7);
    const Rational v(random.integer(-99, 99), 7);
    const Rational g(random.integer(0, 10));
    const Rational h(random.integer(1, 20), 10);
    const SpringDamper<Rational> spring{k, c};
    const auto step = [&](PenaltyScheme scheme) {
      return contact::spring_step<Rational>(scheme, {d, v}, spring, m, h, g);
    };
    const auto change = [&](const PenaltyState<Rational>& x) {
      return m * (x.approach - v) / h - m * g;
    };
    const auto whole = step(PenaltyScheme::implicit_euler);
    REQUIRE(change(whole) == -k * whole.penetration - c * whole.approach);
    REQUIRE(whole.penetration == d + h * whole.approach);
    const auto half = step(PenaltyScheme::implicit_damper);
    REQUIRE(change(half) == -k * d - c * half.approach);
    const auto semi = step(PenaltyScheme::semi_implicit_euler);
    REQUIRE(change(semi) == -k * d - c * v);
    REQUIRE(semi.penetration == d + h * semi.approach);
    const auto plain = step(PenaltyScheme::explicit_euler);
    REQUIRE(plain.approach == semi.approach);
    REQUIRE(plain.penetration == d + h * v);
  }
}

TEST_CASE("with shorter steps each scheme converges to the closed form, at first order") {
  // From the first touch at the start of a step. The error of the restitution is about h: with a
  // step 16 times shorter it is at most a quarter.
  for (const PenaltyScheme scheme : kSchemes) {
    for (const double ratio : {0.0, 0.1, 0.4, 0.9}) {
      for (const ContactRelease rule :
           {ContactRelease::at_zero_force, ContactRelease::at_zero_penetration}) {
        const auto spring = contact::spring_damper(400.0, 2 * ratio * 20);
        const auto impact = contact::spring_impact(spring, 1.0, 1.0, rule);
        const auto off = [&](double h) {
          PenaltyState<double> state{0, 1};
          double deepest = 0;
          for (int n = 0; n * h < 3; ++n) {
            state = contact::penalty_step(scheme, state, spring, 1.0, h, 0.0, rule);
            deepest = std::max(deepest, state.penetration);
          }
          return std::abs(-state.approach - impact.restitution) +
                 20 * std::abs(deepest - impact.max_depth);
        };
        const double coarse = off(1.0 / 4096);
        const double fine = off(1.0 / 65536);
        INFO(static_cast<int>(scheme) << " " << ratio << " " << static_cast<int>(rule));
        CHECK(coarse < 0.1);
        CHECK(fine < 0.004);
        CHECK(fine < coarse / 4 + 1e-4);
      }
    }
  }
}

TEST_CASE("a body at rest on a spring stays at its equilibrium, exactly") {
  Random random(1628);
  for (int i = 0; i < generators::tried(1000); ++i) {
    const Rational k{random.integer(1, 99), random.integer(1, 9)};
    const Rational c{random.integer(0, 99), random.integer(1, 9)};
    const Rational m{random.integer(1, 99), random.integer(1, 9)};
    const Rational g(random.integer(1, 20));
    for (const PenaltyScheme scheme : kSchemes) {
      const PenaltyState<Rational> rest{m * g / k, 0};
      const auto next =
          contact::penalty_step<Rational>(scheme, rest, {k, c}, m, Rational(1, 60), g);
      REQUIRE(next.penetration == rest.penetration);
      REQUIRE(next.approach == 0);
    }
  }
}

}  // namespace penalty_step_test
