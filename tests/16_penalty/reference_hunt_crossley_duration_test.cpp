// The duration of an impact with dissipation: closed forms without it, the same quadrature with
// more nodes, and steps of the equation of motion.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/hunt_crossley_duration.hpp>
#include <contact/penalty_step.hpp>
#include <contact/spring_impact.hpp>
#include <contact/tolerance.hpp>
#include <limits>

#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/refusal.hpp"

namespace hunt_crossley_duration_test {
namespace {

using contact::ContactExponent;
using contact::hunt_crossley;
using contact::hunt_crossley_duration;
using contact::HuntCrossley;
using generators::Random;
using oracle::Interval;
using oracle::Rational;

TEMPLATE_TEST_CASE("without dissipation the duration is that of a spring or of Hertz", "", float,
                   double) {
  using S = TestType;
  Random random(1721);
  const double room = 1e-13 + 2 * double(contact::tolerance::unit_roundoff<S>);
  for (int i = 0; i < generators::tried(300); ++i) {
    const S k = S(std::abs(random.magnitude(-20, 20)));
    const S m = S(std::abs(random.magnitude(-20, 20)));
    const S v = S(std::abs(random.magnitude(-10, 10)));
    const double spring =
        double(contact::spring_impact(contact::spring_damper(k, S(0)), m, v).duration);
    const double linear =
        double(hunt_crossley_duration(hunt_crossley(k, S(0), ContactExponent::linear), m, v));
    REQUIRE(std::abs(linear - spring) <= room * spring);
    const double hertz = double(contact::hertz_impact(contact::hertz_contact(k), m, v).duration);
    REQUIRE(std::abs(double(hunt_crossley_duration(hunt_crossley(k, S(0)), m, v)) - hertz) <=
            room * hertz);
  }
  CHECK(hunt_crossley_duration(hunt_crossley(S(4), S(1), ContactExponent::linear), S(1), S(0)) ==
        S(3.141592653589793 / 2));
  CHECK(std::isinf(hunt_crossley_duration(hunt_crossley(S(4), S(1)), S(1), S(0))));
}

TEST_CASE("roots of the energy of a speed, on both sides") {
  Random random(1722);
  for (int i = 0; i < generators::tried(1000); ++i) {
    const double s = std::abs(random.magnitude(-20, 5));
    const double x = contact::detail::compression_root(s);
    const double q = contact::detail::expansion_root(s * s / 2);
    const auto lift = [](const Rational& y) { return Interval(y, 400); };
    const Rational half = oracle::exact(s) * oracle::exact(s) / 2;
    const Rational room = Rational(1, 1000000) / 10000000;
    const auto compression = [&](const Rational& y) {
      return Interval(lift(y) - log(lift(1 + y)));
    };
    const Rational position = oracle::exact(x);
    INFO(s);
    REQUIRE(compression(position * (1 - room)).low() <= half);
    REQUIRE(compression(position * (1 + room)).high() >= half);
    const Rational other = oracle::exact(q);
    if (other * (1 + room) >= 1) continue;
    const auto expansion = [&](const Rational& y) { return Interval(lift(-y) - log(lift(1 - y))); };
    REQUIRE(expansion(other * (1 - room)).low() <= half);
    REQUIRE(expansion(other * (1 + room)).high() >= half);
  }
}

/// The quadrature with a number of nodes.
double with_nodes(double mu, double first, double p, int nodes) {
  const double largest = p * std::sqrt(2 * contact::detail::compression_share(p));
  double sum = 0;
  for (int j = 0; j < nodes / 2; ++j) {
    const auto turn = contact::sine_cosine(contact::detail::pi * (2 * j + 1) / (2 * nodes));
    sum += contact::detail::fourier_weight(turn, nodes, mu, first) *
           contact::detail::pair_of_speeds(turn.cosine, largest / p, p);
  }
  return sum / nodes;
}

TEST_CASE("more nodes change the duration by less than 1e-13, and far fewer do not reach it") {
  int short_of = 0;
  for (const ContactExponent n : {ContactExponent::linear, ContactExponent::hertz}) {
    const bool linear = n == ContactExponent::linear;
    const double mu = linear ? 1 : 0.8;
    const double first = linear ? contact::detail::pi : 1.25 * contact::hertz_duration_factor();
    for (double p = 0x1p-10; p <= 1000; p *= 1.9) {
      const HuntCrossley<double> contact{1, p, n};
      const double depth = contact::hunt_crossley_depth(contact, 1.0, 1.0);
      const double got = hunt_crossley_duration(contact, 1.0, 1.0) / (mu * depth);
      const double largest = p * std::sqrt(2 * contact::detail::compression_share(p));
      const int nodes = contact::detail::quadrature_nodes(largest);
      INFO(p << " " << nodes);
      const double more = with_nodes(mu, first, p, nodes * 3 / 4 * 2);
      REQUIRE(std::abs(more - got) <= 1e-13 * got);
      if (p > 1) {
        const double less = with_nodes(mu, first, p, nodes / 8 * 2);
        short_of += std::abs(less - got) > 1e-12 * got;
      }
    }
  }
  CHECK(short_of > 10);
}

TEST_CASE("steps of the equation of motion last as long") {
  for (const ContactExponent n : {ContactExponent::linear, ContactExponent::hertz}) {
    for (const double lambda : {0.05, 0.3, 1.0, 4.0, 20.0}) {
      const HuntCrossley<double> contact{100, lambda, n};
      const double duration = hunt_crossley_duration(contact, 2.0, 3.0);
      contact::PenaltyState<double> state{0, 3};
      const int steps = 40000;
      const double h = duration / steps;
      for (int i = 0; i < steps; ++i) {
        state = contact::staged_step(
            contact::PenaltyScheme::runge_kutta_4, state, h,
            [&](double x, double v) { return -contact::hunt_crossley_force(contact, x, v) / 2; });
      }
      INFO(lambda);
      CHECK(std::abs(state.penetration / state.approach) < 1e-8 * duration);
      CHECK(std::abs(-state.approach / 3 - contact::hunt_crossley_restitution(contact, 3.0)) <
            1e-8);
    }
  }
}

TEST_CASE("dissipation makes an impact longer, and one that is too large is refused") {
  double before = 0;
  for (double lambda = 0; lambda < 8; lambda += 0.25) {
    const double now =
        hunt_crossley_duration(HuntCrossley<double>{1, lambda, ContactExponent::hertz}, 1.0, 1.0);
    CHECK(now > before);
    before = now;
  }
  const HuntCrossley<double> contact{1, 1, ContactExponent::hertz};
  CHECK(support::contains(support::refusal([&] { hunt_crossley_duration(contact, 1.0, 1001.0); }),
                          "speed = 1001"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(!support::refusal([&] { hunt_crossley_duration(contact, 1.0, nan); }).empty());
}

}  // namespace
}  // namespace hunt_crossley_duration_test
