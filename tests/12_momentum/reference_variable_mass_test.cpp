// variable_mass.hpp against rational arithmetic on the stored numbers (class (a) of the oracle),
// the rocket against intervals (class (c)).
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/momentum.hpp>
#include <contact/variable_mass.hpp>
#include <limits>

#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/rounding.hpp"

using contact::Vector3;
using generators::any_finite;
using generators::any_vector;
using generators::Random;
using oracle::Rational;
using oracle::Vector;
using rounding::nearest;
using rounding::u;

TEST_CASE("matter that joins or leaves carries its own momentum") {
  Random random(1209);
  for (int i = 0; i < 300; ++i) {
    const auto fraction = [&] { return Rational(random.integer(-50, 50)) / random.integer(1, 9); };
    const Rational m = Rational(random.integer(1, 50)) / random.integer(1, 9);
    const Rational change = fraction();
    const Vector v{fraction(), fraction(), fraction()};
    const Vector w{fraction(), fraction(), fraction()};
    const auto after = contact::velocity_after_exchange(m, v, change, w);
    REQUIRE(after.has_value() == (m + change > 0));
    if (after) REQUIRE(Vector(*after * Rational(m + change)) == Vector(v * m + w * change));
  }
  const Vector3<double> v(3, 0, 0);
  // Sand runs out of a wagon: it leaves with the wagon's velocity, which does not change.
  CHECK(*contact::velocity_after_exchange(5000.0, v, -2000.0, v) == v);
  CHECK(contact::acceleration_with_exchange<double>(5000, {0, 0, 0}, {0, 0, 0}, -100) ==
        Vector3<double>(0, 0, 0));
  // Rain falls into it: the rain must be accelerated to the wagon's speed.
  const auto wet = contact::velocity_after_exchange<double>(5000, v, 1000, {0, 0, 0});
  CHECK(wet->x() == 2.5);
  CHECK(contact::acceleration_with_exchange<double>(5000, {0, 0, 0}, -v, 100).x() == -0.06);
  CHECK_FALSE(contact::velocity_after_exchange<double>(5, v, -5, {0, 0, 0}).has_value());
  const double big = std::numeric_limits<double>::max();
  CHECK(contact::velocity_after_exchange<double>(3, {big, 1, 0}, 1, {-big, 1, 0})->x() == big / 2);
  CHECK(contact::velocity_after_exchange<double>(big, v, big, {1, 0, 0})->x() == 2);
  for (int i = 0; i < 3000; ++i) {
    const double m = std::abs(any_finite(random));
    const double change = random.chance(0.3) ? -m * random.uniform() : any_finite(random);
    const Vector3<double> before = any_vector(random);
    const auto after = contact::velocity_after_exchange(m, before, change, any_vector(random));
    if (after) REQUIRE_FALSE(after->hasNaN());
  }
}

TEST_CASE("a rocket that ejects its mass continuously gains u ln(m0 / m1)") {
  Random random(1210);
  for (int i = 0; i < 400; ++i) {
    const double before = random.uniform(1, 100);
    double after = before * random.uniform(0.01, 1);
    if (random.chance(0.3)) after = before - std::ldexp(before, -random.integer(20, 52));
    const double exhaust = random.uniform(1, 5000);
    const auto right = oracle::nearest_value([&](unsigned bits) {
      const Rational ratio = oracle::exact(before) / oracle::exact(after);
      return oracle::Interval(oracle::exact(exhaust), bits) * log(oracle::Interval(ratio, bits));
    });
    REQUIRE(right.has_value());
    const double got = contact::rocket_speed_gain(exhaust, before, after);
    // Difference, quotient and product round once each, and the logarithm has an error of an ulp;
    // it does not magnify relative errors here.
    REQUIRE(std::abs(got - *right) <= 8 * 0x1p-53 * std::abs(*right));
  }
  // Many small throws approach it from below, with a difference proportional to their size.
  double shortfall = 0;
  for (const int throws : {100, 200}) {
    double mass = 10;
    Vector3<double> v(0, 0, 0);
    for (int k = 0; k < throws; ++k) {
      const double grain = 5.0 / throws;
      const auto apart = contact::push_off<double>(mass - grain, grain, v, {-1000, 0, 0});
      v = apart.first;
      mass -= grain;
    }
    const double missing = contact::rocket_speed_gain(1000.0, 10.0, 5.0) - v.x();
    CHECK(missing > 0);
    if (shortfall > 0) CHECK(std::abs(shortfall / missing - 2) < 0.02);
    shortfall = missing;
  }
}

TEST_CASE("a steady stream changes a velocity by the rocket equation, and conserves momentum") {
  // The textbook's integrals, which divide by the rate, by intervals; the numbers are whole
  // sixteenths, so that the remaining mass is exact.
  Random random(1212);
  const auto some = [&](double size) { return std::round(random.uniform(-size, size) * 16) / 16; };
  for (int i = 0; i < 2000; ++i) {
    const double mass = 8 + std::abs(some(100));
    const double time = 1 + std::abs(some(8));
    double rate = random.chance(0.5) ? some(40) : std::ldexp(some(4), -random.integer(4, 30));
    if (rate == 0) rate = 1;
    const double v0 = some(10);
    const double force = some(50);
    const double u = some(20);
    if (!(mass + rate * time > 0.125)) {
      REQUIRE((mass + rate * time > 0) ==
              contact::after_stream_from_body<double>(mass, {v0, 0, 0}, {force, 0, 0}, {u, 0, 0},
                                                      rate, time)
                  .has_value());
      continue;
    }
    const Rational m0 = oracle::exact(mass);
    const Rational r = oracle::exact(rate);
    const Rational t = oracle::exact(time);
    const Rational m = m0 + r * t;
    const Rational f = oracle::exact(force);
    const Rational v = oracle::exact(v0);
    const Rational w = oracle::exact(u);
    const auto value = [&](const Rational& even, const Rational& logs) {
      return *oracle::nearest_value([&](unsigned bits) {
        return oracle::Interval(even, bits) +
               oracle::Interval(logs, bits) * log(oracle::Interval(Rational(m0 / m), bits));
      });
    };
    const Rational push = f + w * r;
    const auto seen = contact::after_stream_from_body<double>(mass, {v0, 0, 0}, {force, 0, 0},
                                                              {u, 0, 0}, rate, time);
    REQUIRE(seen.has_value());
    const double unit = 0x1p-53;
    const double forces = std::abs(force) + std::abs(u * rate);
    const double gain = value(0, Rational(-1 / r));
    const double far = value(Rational((m0 - m) / (r * r)), Rational(-m / (r * r)));
    REQUIRE(std::abs(seen->velocity.x() - value(v, Rational(-push / r))) <=
            16 * unit * (std::abs(v0) + forces * gain));
    REQUIRE(std::abs(seen->displacement.x() - value(Rational(v * t + push * (m0 - m) / (r * r)),
                                                    Rational(-push * m / (r * r)))) <=
            64 * unit * (std::abs(v0) * time + forces * far));
    // The total momentum of body and matter changes by F t only.
    const double size = (mass + std::abs(rate) * time) *
                        (std::abs(v0) + std::abs(u) + forces * (gain + far / time));
    REQUIRE(std::abs(seen->mass * seen->velocity.x() + seen->carried_off.x() -
                     (mass * v0 + force * time)) <= 256 * unit * size);

    const auto rain = contact::after_stream_over_ground<double>(mass, {v0, 0, 0}, {force, 0, 0},
                                                                {u, 0, 0}, rate, time);
    REQUIRE(rain.has_value());
    const double all = std::abs(force) + (std::abs(v0) + std::abs(u)) * std::abs(rate);
    REQUIRE(std::abs(rain->velocity.x() - oracle::nearest(Rational((m0 * v + push * t) / m))) <=
            8 * unit * (std::abs(v0) + all * time / seen->mass));
    const double wide = value(Rational(t / r), Rational(m0 / (r * r)));
    REQUIRE(std::abs(rain->displacement.x() -
                     value(Rational(push / r * t), Rational(-(v - push / r) * m0 / r))) <=
            64 * unit * (std::abs(v0) * time + all * wide));
    REQUIRE(rain->carried_off.x() == -u * (rate * time));
  }
  // Rain into a wagon, sand that runs out of it, and a force without matter.
  const auto wet =
      contact::after_stream_over_ground<double>(4000, {3, 0, 0}, {0, 0, 0}, {0, 0, 0}, 200, 10);
  CHECK(wet->mass == 6000);
  CHECK(wet->velocity.x() == 2);
  const auto leaks =
      contact::after_stream_from_body<double>(4000, {3, 0, 0}, {0, 0, 0}, {0, 0, 0}, -200, 6);
  CHECK(leaks->velocity == Vector3<double>(3, 0, 0));
  CHECK(leaks->displacement == Vector3<double>(18, 0, 0));
  CHECK(leaks->carried_off == Vector3<double>(3600, 0, 0));
  const auto pushed =
      contact::after_stream_from_body<double>(4, {3, 0, 0}, {2, 0, 0}, {1, 0, 0}, 0, 2);
  CHECK(pushed->velocity.x() == 4);
  CHECK(pushed->displacement.x() == 7);
  CHECK(pushed->carried_off.x() == 0);
  // A rocket, by its own function and by a thousand throws.
  const auto rocket =
      contact::after_stream_from_body<double>(10, {0, 0, 0}, {0, 0, 0}, {-1000, 0, 0}, -1, 5);
  CHECK(std::abs(rocket->velocity.x() - contact::rocket_speed_gain(1000.0, 10.0, 5.0)) < 1e-12);
  CHECK_FALSE(contact::after_stream_over_ground<double>(5, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, -1, 5)
                  .has_value());
  double mass = 10;
  Vector3<double> v(0, 0, 0);
  double displacement = 0;
  for (int k = 0; k < 1000; ++k) {
    const auto after = contact::velocity_after_exchange<double>(
        mass, v, -0.005, Vector3<double>(v + Vector3<double>(-1000, 0, 0)));
    displacement += (v.x() + after->x()) / 2 * 0.005;
    v = *after;
    mass -= 0.005;
  }
  CHECK(std::abs(rocket->velocity.x() / v.x() - 1) < 1e-3);
  CHECK(std::abs(rocket->displacement.x() / displacement - 1) < 1e-3);
}
