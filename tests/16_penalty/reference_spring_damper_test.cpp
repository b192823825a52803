// The force, the energy and the damping regime against fractions (class (a) of the oracle); the
// ratios against square roots of fractions (class (b)). u is the unit roundoff of the type.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/spring_damper.hpp>
#include <contact/tolerance.hpp>
#include <limits>
#include <string>

#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/refusal.hpp"
#include "support/rounding.hpp"

namespace spring_damper_test {

using contact::ContactRelease;
using contact::DampingRegime;
using contact::SpringDamper;
using generators::Random;
using oracle::Rational;
using oracle::Surd;
using rounding::u;
using support::contains;
using support::refusal;

namespace {

template <class S>
SpringDamper<S> any_spring(Random& random, int range) {
  const S k = S(std::abs(random.magnitude(-range, range)));
  const S c = S(random.chance(0.2) ? 0 : std::abs(random.magnitude(-range, range)));
  return contact::spring_damper(k, c);
}

}  // namespace

TEMPLATE_TEST_CASE("the contact force is k d + c d', and a pull only with at_zero_penetration", "",
                   float, double) {
  using S = TestType;
  Random random(1601);
  int pulls = 0;
  int gaps = 0;
  for (int i = 0; i < generators::tried(6000); ++i) {
    const SpringDamper<S> spring = any_spring<S>(random, 12);
    const S d = S(random.chance(0.1) ? 0 : random.magnitude(-12, 2));
    const S v = S(random.magnitude(-8, 8));
    const Rational first = oracle::exact(spring.stiffness) * oracle::exact(d);
    const Rational second = oracle::exact(spring.damping) * oracle::exact(v);
    const S push = contact::contact_force(spring, d, v);
    const S glued = contact::contact_force(spring, d, v, ContactRelease::at_zero_penetration);
    REQUIRE(push >= S(0));
    if (d < S(0)) {
      ++gaps;
      REQUIRE(push == S(0));
      REQUIRE(glued == S(0));
      continue;
    }
    const Rational force = first + second;
    const Rational room = 3 * u<S>() * (abs(first) + abs(second));
    REQUIRE(abs(oracle::exact(glued) - force) <= room);
    REQUIRE(abs(oracle::exact(push) - (force < 0 ? Rational(0) : force)) <= room);
    pulls += force < 0;

    const Rational energy = first * oracle::exact(d) / 2;
    REQUIRE(abs(oracle::exact(contact::contact_spring_energy(spring, d)) - energy) <=
            3 * u<S>() * energy);
  }
  CHECK(pulls > generators::tried(400));
  CHECK(gaps > generators::tried(400));
  CHECK(contact::contact_spring_energy(SpringDamper<S>{S(2), S(1)}, S(-3)) == S(0));
}

TEST_CASE("spring and damper take from the motion what they store and dissipate, exactly") {
  // The rate of k d²/2 is k d d', that of the damper's heat c d'²: together the force times d'.
  Random random(1602);
  for (int i = 0; i < generators::tried(2000); ++i) {
    const Rational k{random.integer(1, 99), random.integer(1, 99)};
    const Rational c{random.integer(0, 99), random.integer(1, 99)};
    const Rational d{random.integer(0, 99), random.integer(1, 99)};
    const Rational v{random.integer(-99, 99), random.integer(1, 99)};
    const auto spring = contact::spring_damper(k, c);
    const Rational step(1, 1 << 20);
    // For a parabola the symmetric difference quotient is the derivative.
    const Rational stored = (contact::contact_spring_energy<Rational>(spring, d + 100 + step) -
                             contact::contact_spring_energy<Rational>(spring, d + 100 - step)) /
                            (2 * step) * v;
    const Rational push =
        contact::contact_force<Rational>(spring, d + 100, v, ContactRelease::at_zero_penetration);
    REQUIRE(push * v == stored + c * v * v);
  }
}

TEMPLATE_TEST_CASE("the damping regime is decided exactly", "", float, double) {
  using S = TestType;
  Random random(1603);
  int close = 0;
  int critical = 0;
  for (int i = 0; i < generators::tried(6000); ++i) {
    S m = S(std::abs(random.magnitude(-20, 20)));
    SpringDamper<S> spring = any_spring<S>(random, 20);
    if (i % 3 == 0) {  // as close to critical as numbers of the type allow
      spring.damping = S(2) * std::sqrt(spring.stiffness) * std::sqrt(m);
      for (int n = random.integer(0, 2); n > 0; --n)
        spring.damping = std::nextafter(spring.damping, S(random.chance(0.5) ? 0 : 1e6));
    } else if (i % 3 == 1) {  // critical: c² = 4 k m with k = p² q and m = r² q
      const int p = random.integer(1, 99);
      const int q = random.integer(1, 9);
      const int r = random.integer(1, 99);
      const S half = S(std::ldexp(1.0, random.integer(-30, 20)));
      spring = contact::spring_damper(S(p * p * q) * half, S(2 * p * q * r) * half);
      m = S(r * r * q) * half;
    }
    const Rational c = oracle::exact(spring.damping);
    const Rational twice = 4 * oracle::exact(spring.stiffness) * oracle::exact(m);
    const Rational discriminant = c * c - twice;
    const DampingRegime right = discriminant < 0   ? DampingRegime::underdamped
                                : discriminant > 0 ? DampingRegime::overdamped
                                                   : DampingRegime::critical;
    REQUIRE(contact::damping_regime(spring, m) == right);
    close += discriminant != 0 && abs(discriminant) < 16 * u<S>() * twice;
    critical += discriminant == 0;

    const Surd ratio{0, c / twice, twice};
    const Surd rate{0, 1 / oracle::exact(m), oracle::exact(spring.stiffness) * oracle::exact(m)};
    REQUIRE(oracle::exact(oracle::error(double(contact::damping_ratio(spring, m)), ratio)) <=
            5 * u<S>() * oracle::exact(oracle::nearest(ratio)) * Rational(101, 100));
    REQUIRE(oracle::exact(oracle::error(double(contact::natural_frequency(spring, m)), rate)) <=
            3 * u<S>() * oracle::exact(oracle::nearest(rate)) * Rational(101, 100));
  }
  CHECK(close > generators::tried(500));
  CHECK(critical > generators::tried(500));
}

TEMPLATE_TEST_CASE("a damping ratio that overflows is the largest finite number", "", float,
                   double) {
  using S = TestType;
  const S tiny = std::numeric_limits<S>::min();
  const SpringDamper<S> spring = contact::spring_damper(tiny, std::numeric_limits<S>::max());
  CHECK(contact::damping_ratio(spring, tiny) == std::numeric_limits<S>::max());
  CHECK(contact::damping_regime(spring, tiny) == DampingRegime::overdamped);
}

TEST_CASE("an invalid spring or damper is refused, with its value") {
  const double inf = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double k : {0.0, -1.0, inf, nan}) {
    const std::string said = refusal([k] { contact::spring_damper(k, 0.0); });
    CHECK(contains(said, "stiffness"));
    CHECK(contains(said, contact::number_text(k)));
  }
  for (const double c : {-1e-300, -inf, inf, nan}) {
    const std::string said = refusal([c] { contact::spring_damper(1.0, c); });
    CHECK(contains(said, "damping"));
    CHECK(contains(said, contact::number_text(c)));
  }
  CHECK(refusal([] { contact::spring_damper(1e-300, 0.0); }).empty());
}

}  // namespace spring_damper_test
