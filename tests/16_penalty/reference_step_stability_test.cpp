// Verlet's steps and the Runge–Kutta step on a contact spring: stability from the eigenvalues in
// fractions (class (a) and (b) of the oracle), limits against the decision on both sides, and the
// shape of the Runge–Kutta region by intervals (class (c)).
#include <algorithm>
#include <array>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/penalty_step.hpp>
#include <contact/spring_impact.hpp>
#include <contact/tolerance.hpp>
#include <vector>

#include "support/generators.hpp"
#include "support/oracle.hpp"

namespace step_stability_test {
namespace {

using contact::PenaltyScheme;
using contact::PenaltyState;
using contact::SpringDamper;
using contact::step_behaviour;
using contact::step_limit;
using contact::StepBehaviour;
using generators::Random;
using oracle::Interval;
using oracle::Rational;
using oracle::Surd;

constexpr std::array<PenaltyScheme, 3> kStaged{
    PenaltyScheme::velocity_verlet, PenaltyScheme::position_verlet, PenaltyScheme::runge_kutta_4};

/// The behaviour by the roots of the characteristic polynomial of the matrix of spring_step().
StepBehaviour by_roots(PenaltyScheme scheme, const SpringDamper<Rational>& spring,
                       const Rational& m, const Rational& h) {
  const auto first = contact::spring_step<Rational>(scheme, {1, 0}, spring, m, h, 0);
  const auto second = contact::spring_step<Rational>(scheme, {0, 1}, spring, m, h, 0);
  const Rational trace = first.penetration + second.approach;
  const Rational product =
      first.penetration * second.approach - first.approach * second.penetration;
  const Rational discriminant = trace * trace - 4 * product;
  if (discriminant < 0) {
    if (product == 1) return StepBehaviour::bounded;
    return product < 1 ? StepBehaviour::decays : StepBehaviour::grows;
  }
  const int top = oracle::compare(Surd{trace / 2, Rational(1, 2), discriminant}, {1, 0, 0});
  const int bottom = oracle::compare(Surd{trace / 2, Rational(-1, 2), discriminant}, {-1, 0, 0});
  if (top > 0 || bottom < 0) return StepBehaviour::grows;
  if (top < 0 && bottom > 0) return StepBehaviour::decays;
  return discriminant == 0 ? StepBehaviour::grows : StepBehaviour::bounded;
}

template <class S>
SpringDamper<Rational> lifted(const SpringDamper<S>& spring) {
  return {oracle::exact(spring.stiffness), oracle::exact(spring.damping)};
}

/// A spring, a mass and a damper of any damping ratio from 2^-20 to 2^6, or none.
template <class S>
struct Oscillator {
  SpringDamper<S> spring;
  S mass;

  Oscillator(Random& random, int range) : mass(S(std::abs(random.magnitude(-range, range)))) {
    const S k = S(std::abs(random.magnitude(-range, range)));
    const double ratio = random.chance(0.5)   ? random.uniform(0, 1.2)
                         : random.chance(0.2) ? 0
                                              : std::abs(random.magnitude(-20, 6));
    spring =
        contact::spring_damper(k, S(2 * ratio * std::sqrt(double(k)) * std::sqrt(double(mass))));
  }
};

TEMPLATE_TEST_CASE("stability of Verlet and Runge–Kutta is that of the eigenvalues", "", float,
                   double) {
  using S = TestType;
  Random random(1641);
  std::array<std::array<int, 3>, 3> seen{};
  for (int i = 0; i < generators::tried(1500); ++i) {
    Oscillator<S> body(random, 8);
    S h{};
    if (i % 2 == 0) {  // integers give many ties
      const int k = random.integer(1, 16);
      const int c = random.integer(0, 12);
      body.spring = contact::spring_damper(S(k), S(c));
      body.mass = S(random.integer(1, 6));
      h = S(std::ldexp(random.integer(1, 4), random.integer(-2, 1)));
      if (i % 20 == 0) {  // ω₀ h = 2 √2, where Runge–Kutta neither gains nor loses
        body.spring = contact::spring_damper(S(8) * body.mass, S(0));
        h = S(1);
      }
    } else {
      h = step_limit(kStaged[static_cast<std::size_t>(random.integer(0, 2))], body.spring,
                     body.mass);
      for (int n = random.integer(0, 2); n > 0; --n)
        h = std::nextafter(h, S(random.chance(0.5) ? 0 : 1e9));
    }
    for (std::size_t s = 0; s < kStaged.size(); ++s) {
      const StepBehaviour right =
          by_roots(kStaged[s], lifted(body.spring), oracle::exact(body.mass), oracle::exact(h));
      INFO(int(kStaged[s]) << " " << body.spring.stiffness << " " << body.spring.damping << " "
                           << body.mass << " " << h);
      REQUIRE(step_behaviour(kStaged[s], body.spring, body.mass, h) == right);
      ++seen[s][static_cast<std::size_t>(right)];
    }
  }
  for (const auto& counts : seen) {
    for (const int count : counts) CHECK(count > generators::tried(20));
  }
}

TEMPLATE_TEST_CASE("below their limits Verlet and Runge–Kutta never grow, and above they do", "",
                   float, double) {
  using S = TestType;
  Random random(1642);
  const S u = contact::tolerance::unit_roundoff<S>;
  int late = 0;
  for (int i = 0; i < generators::tried(400); ++i) {
    const Oscillator<S> body(random, 20);
    for (const PenaltyScheme scheme : kStaged) {
      const S limit = step_limit(scheme, body.spring, body.mass);
      INFO(int(scheme) << " " << body.spring.stiffness << " " << body.spring.damping << " "
                       << body.mass << " " << limit);
      const auto grows = [&](const S& h) {
        return step_behaviour(scheme, body.spring, body.mass, h) == StepBehaviour::grows;
      };
      REQUIRE(grows(limit * (S(1) + S(16) * u)));
      REQUIRE(!grows(limit * (S(1) - S(16) * u)));
      // The first step that grows: none of shorter ones does, from near the limit to far below.
      for (int n = 0; n < 6; ++n) REQUIRE(!grows(S(limit * S(random.uniform()))));
      if (scheme == PenaltyScheme::velocity_verlet && body.spring.damping > S(0)) {
        // Longer ones up to 4 m / c may decay again, which the limit must not rely on.
        const S last = S(4) * body.mass / body.spring.damping * (S(1) - S(16) * u);
        late += last > limit * S(1.01) && !grows(last);
      }
    }
  }
  CHECK(late > generators::tried(100));
}

TEMPLATE_TEST_CASE("limits of Verlet and Runge–Kutta that have a closed form", "", float, double) {
  using S = TestType;
  Random random(1643);
  const double u = double(contact::tolerance::unit_roundoff<S>);
  for (int i = 0; i < generators::tried(300); ++i) {
    const S k = S(std::abs(random.magnitude(-20, 20)));
    const S m = S(std::abs(random.magnitude(-20, 20)));
    const Rational square = oracle::exact(m) / oracle::exact(k);
    const auto undamped = contact::spring_damper(k, S(0));
    const auto is = [&](PenaltyScheme scheme, const SpringDamper<S>& spring, const Surd& right) {
      const S limit = step_limit(scheme, spring, m);
      REQUIRE(oracle::error(double(limit), right) <= 8 * u * oracle::nearest(right));
    };
    is(PenaltyScheme::velocity_verlet, undamped, {0, 2, square});
    is(PenaltyScheme::position_verlet, undamped, {0, 2, square});
    is(PenaltyScheme::runge_kutta_4, undamped, {0, 2, 2 * square});
    // From ζ = 0.53 on, only D = 1 limits velocity Verlet: 4 m / c.
    const S c = S(random.uniform(1.06, 8) * std::sqrt(double(k)) * std::sqrt(double(m)));
    is(PenaltyScheme::velocity_verlet, contact::spring_damper(k, c),
       {4 * oracle::exact(m) / oracle::exact(c), 0, 0});
  }
}

TEST_CASE("velocity Verlet has steps that grow between steps that decay") {
  // ζ = 0.1, ω₀ = 1: from the limit 1.91… the steps grow, but near 4 m / c = 20 they decay.
  const auto spring = contact::spring_damper(1.0, 0.2);
  const auto behaviour = [&](double h) {
    return step_behaviour(PenaltyScheme::velocity_verlet, spring, 1.0, h);
  };
  CHECK(behaviour(1.9) == StepBehaviour::decays);
  CHECK(behaviour(2.0) == StepBehaviour::grows);
  CHECK(behaviour(10.0) == StepBehaviour::grows);
  CHECK(behaviour(19.95) == StepBehaviour::decays);
  CHECK(behaviour(20.1) == StepBehaviour::grows);
  // Between ζ = 0.5262 and 0.5263 the range of growing steps closes.
  CHECK(step_limit(PenaltyScheme::velocity_verlet, contact::spring_damper(1.0, 1.0525), 1.0) < 2.5);
  CHECK(step_limit(PenaltyScheme::velocity_verlet, contact::spring_damper(1.0, 1.0526), 1.0) > 3.5);
}

/// (|R|² − 1) / ρ of the Runge–Kutta step for the rates ρ (−ζ ± i √(1 − ζ²)), and its slope in ρ.
struct RayPolynomial {
  std::array<Interval, 8> term;  // coefficients in ζ, of ρ⁰ to ρ⁷

  explicit RayPolynomial(const Interval& z)
      : term{[&] {
          const auto number = [&](const Rational& x) { return Interval(x, z.bits()); };
          const Interval z2 = z * z;
          return std::array<Interval, 8>{number(-2) * z,
                                         number(2) * z2,
                                         number(Rational(-4, 3)) * z2 * z,
                                         number(Rational(2, 3)) * z2 * z2,
                                         z * (number(1) - number(4) * z2) * number(Rational(1, 12)),
                                         (number(6) * z2 - number(1)) * number(Rational(1, 72)),
                                         number(Rational(-1, 72)) * z,
                                         number(Rational(1, 576))};
        }()} {}

  Interval at(const Interval& r) const {
    Interval sum = term[7];
    for (std::size_t i = 7; i-- > 0;) sum = sum * r + term[i];
    return sum;
  }
  Interval slope(const Interval& r) const {
    Interval sum(Rational(0), r.bits());
    for (std::size_t i = 7; i >= 1; --i)
      sum = sum * r + Interval(Rational(int(i)), r.bits()) * term[i];
    return sum;
  }
};

TEST_CASE("along every ray of rates the Runge–Kutta step begins to grow once") {
  // The polynomial is negative from 0 to 2.5 and positive at 3.5; between, its slope is positive
  // wherever it may be 0. So it has one root there, the first step that grows, and
  // runge_kutta_limit brackets it. Boxes of (ζ, ρ) are halved until one of the three holds.
  struct Box {
    Rational z0, z1, r0, r1;
  };
  std::vector<Box> boxes{{0, 1, Rational(1, 4), Rational(7, 2)}};
  int proved = 0;
  while (!boxes.empty()) {
    const Box box = boxes.back();
    boxes.pop_back();
    REQUIRE(++proved < 200000);
    const Interval z(box.z0, box.z1, 64);
    const Interval r(box.r0, box.r1, 64);
    const RayPolynomial q(z);
    const Interval value = q.at(r);
    if (value.high() < 0) continue;
    if (box.r0 >= Rational(5, 2)) {
      if (value.low() > 0 && box.r1 < 3) continue;
      if (q.slope(r).low() > 0) continue;
    }
    REQUIRE(box.z1 - box.z0 > Rational(1, 4096));
    const Rational z_middle = (box.z0 + box.z1) / 2;
    const Rational r_middle = (box.r0 + box.r1) / 2;
    if (box.z1 - box.z0 > box.r1 - box.r0) {
      boxes.push_back({box.z0, z_middle, box.r0, box.r1});
      boxes.push_back({z_middle, box.z1, box.r0, box.r1});
    } else {
      boxes.push_back({box.z0, box.z1, box.r0, r_middle});
      boxes.push_back({box.z0, box.z1, r_middle, box.r1});
    }
  }
  for (int i = 0; i < 1024; ++i) {
    const Interval z(Rational(i, 1024), Rational(i + 1, 1024), 64);
    REQUIRE(RayPolynomial(z).at(Interval(Rational(7, 2), 64)).low() > 0);
    const Interval small(0, Rational(1, 4), 64);
    if (i >= 16) REQUIRE(RayPolynomial(z).at(small).high() < 0);
  }
  // Where ζ and ρ are both small, ζ times a negative number and ρ⁵ times a negative one.
  const auto number = [](const Rational& x) { return Interval(x, 64); };
  const Interval z(0, Rational(1, 64), 64);
  const Interval r(0, Rational(1, 4), 64);
  const Interval y = z * r;
  const Interval of_z = number(-2) + number(2) * y + number(Rational(2, 3)) * y * y * y +
                        r * r * r * r * number(Rational(1, 12));
  const Interval of_r =
      (number(6) * z * z - number(1)) * number(Rational(1, 72)) + r * r * number(Rational(1, 576));
  CHECK(of_z.high() < -1);
  CHECK(of_r.high() < 0);
}

TEST_CASE("the polynomial along a ray is that of the steps, exactly") {
  Random random(1644);
  for (int i = 0; i < generators::tried(200); ++i) {
    const Rational z(random.integer(0, 64), 64);
    const Rational r(random.integer(1, 224), 64);
    const SpringDamper<Rational> spring{1, 2 * z};
    const auto a =
        contact::spring_step<Rational>(PenaltyScheme::runge_kutta_4, {1, 0}, spring, 1, r, 0);
    const auto b =
        contact::spring_step<Rational>(PenaltyScheme::runge_kutta_4, {0, 1}, spring, 1, r, 0);
    const Rational determinant = a.penetration * b.approach - a.approach * b.penetration;
    const Interval value = RayPolynomial(Interval(z, 512)).at(Interval(r, 512));
    REQUIRE(value.low() <= (determinant - 1) / r);
    REQUIRE((determinant - 1) / r <= value.high());
    REQUIRE(value.high() - value.low() < Rational(1, 1000000));
  }
}

TEST_CASE("Verlet and Runge–Kutta keep a body at rest at rest, exactly") {
  Random random(1645);
  for (int i = 0; i < generators::tried(300); ++i) {
    const Rational k{random.integer(1, 99), random.integer(1, 9)};
    const Rational c{random.integer(0, 99), random.integer(1, 9)};
    const Rational m{random.integer(1, 99), random.integer(1, 9)};
    const Rational g(random.integer(1, 20));
    for (const PenaltyScheme scheme : kStaged) {
      const PenaltyState<Rational> rest{m * g / k, 0};
      const auto next =
          contact::penalty_step<Rational>(scheme, rest, {k, c}, m, Rational(1, 60), g);
      REQUIRE(next.penetration == rest.penetration);
      REQUIRE(next.approach == 0);
    }
  }
}

TEST_CASE("free flight under gravity is exact with Verlet and Runge–Kutta") {
  Random random(1646);
  for (int i = 0; i < generators::tried(300); ++i) {
    const Rational h(random.integer(1, 20), 10);
    const Rational g(random.integer(0, 20));
    const Rational v(-random.integer(1, 99), 7);
    const Rational x = -1000;
    for (const PenaltyScheme scheme : kStaged) {
      const auto next = contact::penalty_step<Rational>(scheme, {x, v}, {4, 1}, 1, h, g);
      REQUIRE(next.approach == v + h * g);
      REQUIRE(next.penetration == x + h * v + h * h * g / 2);
    }
  }
}

TEST_CASE("on an attached spring Verlet has order 2 and Runge–Kutta order 4") {
  // With steps 4 times shorter the error falls by more than 12 and 200; damping keeps the order of
  // both but for Verlet, whose damper uses a velocity that is half a step old.
  for (const PenaltyScheme scheme : kStaged) {
    const bool fourth = scheme == PenaltyScheme::runge_kutta_4;
    const auto spring = contact::spring_damper(1.0, fourth ? 0.3 : 0.0);
    const auto off = [&](int steps) {
      PenaltyState<double> state{0, 1};
      const double h = 2.0 / steps;
      for (int n = 0; n < steps; ++n)
        state = contact::spring_step(scheme, state, spring, 1.0, h, 0.0);
      PenaltyState<double> fine{0, 1};
      for (int n = 0; n < 4096; ++n)
        fine =
            contact::spring_step(PenaltyScheme::runge_kutta_4, fine, spring, 1.0, 2.0 / 4096, 0.0);
      return std::hypot(state.penetration - fine.penetration, state.approach - fine.approach);
    };
    CHECK(off(16) > (fourth ? 200 : 12) * off(64));
  }
}

TEST_CASE("no force evaluation of a staged step pulls at zero force") {
  Random random(1647);
  int pulled = 0;
  for (int i = 0; i < generators::tried(2000); ++i) {
    const SpringDamper<Rational> spring{Rational(random.integer(1, 64), 16),
                                        Rational(random.integer(0, 64), 16)};
    const PenaltyState<Rational> now{Rational(random.integer(-32, 32), 16),
                                     Rational(random.integer(-64, 64), 16)};
    const Rational h(1, 1 << random.integer(0, 4));
    for (const PenaltyScheme scheme : kStaged) {
      const auto next = contact::penalty_step<Rational>(scheme, now, spring, 1, h, 0);
      REQUIRE(next.approach <= now.approach);
      const auto glued = contact::penalty_step<Rational>(
          scheme, now, spring, 1, h, 0, contact::ContactRelease::at_zero_penetration);
      pulled += glued.approach > now.approach;
    }
  }
  CHECK(pulled > generators::tried(100));
}

}  // namespace
}  // namespace step_stability_test
