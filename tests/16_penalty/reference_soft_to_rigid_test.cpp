// The motion of an impact over time against the power series of its equation of motion in intervals
// (class (d) of the oracle), its impulse against a quadrature, and the difference from a rigid
// jump.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/soft_to_rigid.hpp>
#include <contact/tolerance.hpp>
#include <limits>

#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/refusal.hpp"

namespace soft_to_rigid_test {
namespace {

using contact::ContactRelease;
using contact::PenaltyState;
using contact::spring_impact;
using contact::SpringDamper;
using generators::Random;
using oracle::Interval;
using oracle::Rational;

constexpr double kUnit = 0x1p-53;

double middle(const Interval& x) { return oracle::nearest(Rational((x.low() + x.high()) / 2)); }

/// x and ẋ of m ẍ = m load − k x − c ẋ after a time t, by the power series in t.
PenaltyState<double> by_series(const PenaltyState<double>& start, const SpringDamper<double>& s,
                               double mass, double load, double t) {
  constexpr unsigned bits = 384;
  const auto lift = [](const Rational& x) { return Interval(x, bits); };
  const Rational time = oracle::exact(t);
  const Interval a = lift(oracle::exact(s.stiffness) / oracle::exact(mass) * time * time);
  const Interval b = lift(oracle::exact(s.damping) / oracle::exact(mass) * time);
  Interval earlier = lift(oracle::exact(start.penetration));
  Interval now = lift(oracle::exact(start.approach) * time);
  Interval place = earlier + now;
  Interval speed = now;
  for (int n = 0; n < 200; ++n) {
    Interval next =
        -(a * earlier / lift(Rational((n + 1) * (n + 2)))) - b * now / lift(Rational(n + 2));
    if (n == 0) next = next + lift(oracle::exact(load) * time * time / 2);
    place = place + next;
    speed = speed + next * lift(Rational(n + 2));
    earlier = now;
    now = next;
  }
  return {middle(place), middle(speed / lift(time))};
}

/// From none to heavy damping, and as close to critical as numbers allow.
double any_ratio(Random& random, int i) {
  if (i % 4 == 0) return random.uniform(0, 1);
  if (i % 4 == 1) return 1 + random.uniform(-0x1p-20, 0x1p-20);
  if (i % 4 == 2) return random.uniform(1, 4);
  return random.chance(0.3) ? 0 : 1 + std::ldexp(random.uniform(-1, 1), -random.integer(1, 50));
}

TEMPLATE_TEST_CASE("the attached motion is that of the power series", "", float, double) {
  using S = TestType;
  Random random(1661);
  for (int i = 0; i < generators::tried(600); ++i) {
    const S m = S(std::abs(random.magnitude(-10, 10)));
    const S k = S(std::abs(random.magnitude(-10, 10)));
    const double z = any_ratio(random, i);
    const SpringDamper<S> spring{k, S(2 * z * std::sqrt(double(k)) * std::sqrt(double(m)))};
    const double rate = std::sqrt(double(k) / double(m));
    const S t = S(random.uniform(0, 6) / rate);
    const S v = S(random.magnitude(-5, 5));
    const PenaltyState<S> start{S(random.magnitude(-5, 5) / rate), v};
    const S load = S(random.chance(0.5) ? 0 : random.uniform(-9, 9) * rate * double(v));
    const auto got = contact::damped_motion(start, spring, m, load, t);
    const auto right =
        by_series({double(start.penetration), double(start.approach)},
                  {double(k), double(spring.damping)}, double(m), double(load), double(t));
    const double size = std::abs(double(start.penetration)) + std::abs(double(v)) / rate +
                        std::abs(double(load)) / (rate * rate);
    const double room = (60 + 8 * rate * (1 + z) * double(t)) * (1 + z) * kUnit * size;
    const double u = double(contact::tolerance::unit_roundoff<S>);
    INFO(z << " " << rate * double(t));
    REQUIRE(std::abs(double(got.penetration) - right.penetration) <=
            room + 1.001 * u * std::abs(right.penetration));
    REQUIRE(std::abs(double(got.approach) - right.approach) <=
            rate * room + 1.001 * u * std::abs(right.approach));
  }
}

TEST_CASE("heavily damped and stiff motions neither overflow nor leave their bounds") {
  Random random(1662);
  for (int i = 0; i < generators::tried(2000); ++i) {
    const double m = std::abs(random.magnitude(-60, 60));
    const double k = std::abs(random.magnitude(-60, 60));
    const double z = i % 2 == 0 ? random.uniform(0, 2) : std::abs(random.magnitude(0, 30));
    const SpringDamper<double> spring{k, 2 * z * std::sqrt(k) * std::sqrt(m)};
    const double rate = std::sqrt(k / m);
    const double t = std::abs(random.magnitude(-40, 40)) / rate;
    const auto state = contact::damped_motion(PenaltyState<double>{0, 1}, spring, m, 0.0, t);
    REQUIRE(std::abs(state.penetration) * rate <= 1.0000001);
    REQUIRE(std::abs(state.approach) <= 1.0000001);
  }
}

TEST_CASE("critical damping returns fastest in the end, except from particular starts") {
  const auto size = [](double ratio, const PenaltyState<double>& start) {
    const auto state =
        contact::damped_motion(start, SpringDamper<double>{1, 2 * ratio}, 1.0, 0.0, 200.0);
    return std::abs(state.penetration) + std::abs(state.approach);
  };
  for (const double ratio : {0.0, 0.5, 0.9, 1.1, 2.0, 10.0})
    for (const auto& start : {PenaltyState<double>{1, 0}, {0, 1}, {1, -1.5}})
      CHECK(size(ratio, start) > 10 * size(1, start));
  // From here an overdamped body has its faster rate only.
  const contact::PenaltyState<double> fast{1, -2 - std::sqrt(3.0)};
  const auto soon = [&](double ratio) {
    return contact::damped_motion(fast, SpringDamper<double>{1, 2 * ratio}, 1.0, 0.0, 5.0);
  };
  CHECK(std::abs(soon(2).penetration) < 0.01 * std::abs(soon(1).penetration));
}

TEST_CASE("at zero force an impact never pulls, and at zero penetration a damped one does") {
  Random random(1663);
  int pulls = 0;
  for (int i = 0; i < generators::tried(400); ++i) {
    const double z = any_ratio(random, i);
    const SpringDamper<double> spring{100, 20 * z};
    const auto free = spring_impact(spring, 1.0, 2.0);
    for (int n = 0; n <= 40; ++n) {
      const double t = free.duration * n / 32;
      const auto moment = contact::impact_at(spring, 1.0, 2.0, t);
      REQUIRE(moment.force >= 0);
      REQUIRE(moment.force <= free.max_force * (1 + 1e-12));
      REQUIRE(moment.touching == (n <= 32));
      if (n > 32) {
        REQUIRE(moment.force == 0);
        REQUIRE(moment.state.approach == -free.restitution * 2);
      }
    }
    const auto glued = spring_impact(spring, 1.0, 2.0, ContactRelease::at_zero_penetration);
    if (!(z > 0.01) || std::isinf(glued.duration)) continue;
    const double late = free.duration + 0.9 * (glued.duration - free.duration);
    const auto moment =
        contact::impact_at(spring, 1.0, 2.0, late, ContactRelease::at_zero_penetration);
    REQUIRE(moment.touching);
    REQUIRE(moment.state.penetration >= -1e-14);
    if (glued.duration < 100) {
      REQUIRE(moment.force < 0);
      ++pulls;
    }
  }
  CHECK(pulls > generators::tried(50));
}

TEST_CASE("a moment of an impact continues into the flight after it") {
  for (const double z : {0.0, 0.2, 0.7, 1.0, 3.0}) {
    const SpringDamper<double> spring{400, 40 * z};
    const auto impact = spring_impact(spring, 1.0, 3.0);
    const auto before = contact::impact_at(spring, 1.0, 3.0, impact.duration);
    const auto after = contact::impact_at(spring, 1.0, 3.0, impact.duration + 0.5);
    CHECK(before.touching);
    CHECK(!after.touching);
    CHECK(std::abs(before.state.penetration - impact.left_overlap) < 1e-14);
    CHECK(std::abs(before.state.approach - after.state.approach) < 1e-13);
    CHECK(std::abs(after.state.penetration -
                   (before.state.penetration + 0.5 * after.state.approach)) < 1e-13);
  }
}

/// ∫ F dt by Simpson's rule.
double area(const SpringDamper<double>& spring, double mass, double speed, ContactRelease rule) {
  const double end = spring_impact(spring, mass, speed, rule).duration;
  constexpr int pieces = 512;
  double sum = 0;
  for (int n = 0; n <= pieces; ++n) {
    const int weight = n == 0 || n == pieces ? 1 : (n % 2 == 0 ? 2 : 4);
    sum += weight * contact::impact_at(spring, mass, speed, end * n / pieces, rule).force;
  }
  return sum * end / pieces / 3;
}

TEST_CASE("the area under the force is m (1 + e) v") {
  Random random(1664);
  for (int i = 0; i < generators::tried(150); ++i) {
    const double m = std::abs(random.magnitude(-10, 10));
    const double k = std::abs(random.magnitude(-10, 20));
    const double v = std::abs(random.magnitude(-10, 10));
    const double z = random.uniform(0, i % 2 == 0 ? 0.8 : 2);
    const SpringDamper<double> spring{k, 2 * z * std::sqrt(k * m)};
    const double impulse = contact::contact_impulse(spring, m, v);
    REQUIRE(std::abs(area(spring, m, v, ContactRelease::at_zero_force) - impulse) <=
            1e-8 * impulse);
    if (z > 0.8) continue;
    const auto rule = ContactRelease::at_zero_penetration;
    const double glued = contact::contact_impulse(spring, m, v, rule);
    REQUIRE(std::abs(area(spring, m, v, rule) - glued) <= 1e-8 * impulse);
    REQUIRE(glued <= impulse * (1 + 1e-14));  // the pull takes some of it back
  }
}

TEMPLATE_TEST_CASE("the impulse is the same for every stiffness; duration and depth shrink", "",
                   float, double) {
  using S = TestType;
  Random random(1665);
  for (int i = 0; i < generators::tried(1000); ++i) {
    const S m = S(std::abs(random.magnitude(-5, 5)));
    const SpringDamper<S> soft{S(std::abs(random.magnitude(-5, 5))),
                               S(random.chance(0.3) ? 0 : std::abs(random.magnitude(-5, 5)))};
    const S v = S(random.uniform(0.5, 2));
    const S f =
        S(std::ldexp(1.0, random.integer(-5, 5)));  // a power of two, so no product is rounded
    const auto hard = contact::stiffened(soft, f);
    REQUIRE(contact::contact_impulse(hard, m, v) == contact::contact_impulse(soft, m, v));
    const auto a = spring_impact(soft, m, v);
    const auto b = spring_impact(hard, m, v);
    REQUIRE(b.restitution == a.restitution);
    REQUIRE(b.duration * f == a.duration);
    REQUIRE(b.max_depth * f == a.max_depth);
    REQUIRE(b.max_force == a.max_force * f);
  }
  CHECK(!support::refusal([] { contact::stiffened(SpringDamper<double>{1, 1}, 0.0); }).empty());
  CHECK(!support::refusal([] { contact::stiffened(SpringDamper<double>{1, 1}, 1e200); }).empty());
  CHECK(!support::refusal([] { contact::stiffened(SpringDamper<double>{1, 1}, 1e-200); }).empty());
}

TEMPLATE_TEST_CASE("an undamped bounce under gravity is the rigid one, later by the contact", "",
                   float, double) {
  using S = TestType;
  Random random(1666);
  const double u = double(contact::tolerance::unit_roundoff<S>);
  for (int i = 0; i < generators::tried(1000); ++i) {
    const S m = S(std::abs(random.magnitude(-8, 8)));
    const S k = S(std::abs(random.magnitude(-8, 8)));
    const S v = S(std::abs(random.magnitude(-4, 4)));
    const S g = S(i % 10 == 0 ? 0 : std::abs(random.magnitude(-6, 6)));
    const auto jump = contact::jump_difference(k, m, v, g);
    // The angle by intervals: β = atan(ω₀ v / g).
    constexpr unsigned bits = 256;
    const auto lift = [](const Rational& x) { return Interval(x, bits); };
    const Interval rate = sqrt(lift(Rational(oracle::exact(k) / oracle::exact(m))));
    const Interval quarter = Interval::pi(bits) / lift(2);
    const Interval less = atan(lift(oracle::exact(g)) / (rate * lift(oracle::exact(v))));
    const Interval delay = lift(2) * (quarter + less) / rate;
    REQUIRE(std::abs(double(jump.delay) - middle(delay)) <= 60 * u * middle(delay));
    REQUIRE(std::abs(double(jump.velocity) - double(g) * middle(delay)) <=
            60 * u * double(g) * middle(delay));
    REQUIRE(std::abs(double(jump.position) - double(v) * middle(delay)) <=
            60 * u * double(v) * middle(delay));
    REQUIRE(jump.delay <= S(6.2831855) * std::sqrt(m) / std::sqrt(k));
    // It leaves with the speed v at zero penetration, by the closed motion under the load.
    const auto end = contact::damped_motion(PenaltyState<double>{0, double(v)},
                                            SpringDamper<double>{double(k), 0}, double(m),
                                            double(g), middle(delay));
    const double w = middle(rate);
    REQUIRE(std::abs(end.penetration) <= 1e-13 * (double(v) / w + double(g) / (w * w)));
    REQUIRE(std::abs(end.approach + double(v)) <= 1e-13 * (double(v) + double(g) / w));
  }
}

TEST_CASE("while both fly, soft and rigid heights differ by at most the bound") {
  Random random(1667);
  for (int i = 0; i < generators::tried(500); ++i) {
    const double v = random.uniform(0.5, 5);
    const double g = random.uniform(0.5, 20);
    const double k = std::abs(random.magnitude(4, 20));
    const auto jump = contact::jump_difference(k, 1.0, v, g);
    const auto height = [&](double t) { return t * (v - g * t / 2); };
    // A soft contact may outlast the rigid flight; then the two never fly at once.
    for (int n = 0; n <= 16 && jump.delay < 2 * v / g; ++n) {
      const double t = jump.delay + (2 * v / g - jump.delay) * n / 16;
      REQUIRE(std::abs(height(t) - height(t - jump.delay)) <= jump.position * (1 + 1e-12));
    }
    // A hundred times as stiff is ten times as near, but for gravity's part of the delay.
    const auto harder = contact::jump_difference(100 * k, 1.0, v, g);
    REQUIRE(harder.position <= jump.position / 10 * (1 + 1e-12));
    REQUIRE(harder.velocity <= jump.velocity / 10 * (1 + 1e-12));
  }
}

TEST_CASE("gravity changes the velocity in a contact by g x / v, within its bound") {
  Random random(1668);
  double largest = 0;
  for (int i = 0; i < generators::tried(1000); ++i) {
    const double m = std::abs(random.magnitude(-8, 8));
    const double k = std::abs(random.magnitude(-8, 8));
    const double z = any_ratio(random, i);
    const SpringDamper<double> spring{k, 2 * z * std::sqrt(k) * std::sqrt(m)};
    const double v = random.uniform(0.5, 5);
    const double g = random.uniform(0, 20);
    const double rate = std::sqrt(k / m);
    const double t = random.uniform(0, 3.2) / rate;
    const PenaltyState<double> start{0, v};
    const auto without = contact::damped_motion(start, spring, m, 0.0, t);
    const auto with = contact::damped_motion(start, spring, m, g, t);
    const double change = with.approach - without.approach;
    const double room = 1e-12 * (v + g / rate);
    REQUIRE(std::abs(change - g * without.penetration / v) <= room);
    const double bound = contact::gravity_velocity_bound(spring, m, g);
    REQUIRE(change <= bound + room);
    if (bound > 0) largest = std::max(largest, change / bound);
  }
  CHECK(largest > 0.99);
}

}  // namespace
}  // namespace soft_to_rigid_test
