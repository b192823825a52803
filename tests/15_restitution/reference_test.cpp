// Every reference function of the chapter against fractions and square roots of fractions (classes
// (a) and (b) of the oracle), angles against intervals (class (c)). u is the unit roundoff of the
// type. A bound that a comment of the reference gives is tested as it stands.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/bouncing.hpp>
#include <contact/fixed_step_bounce.hpp>
#include <contact/impulse.hpp>
#include <contact/rebound_angle.hpp>
#include <contact/restitution.hpp>
#include <contact/stacked_drop.hpp>
#include <limits>
#include <numbers>
#include <string>

#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/refusal.hpp"
#include "support/rounding.hpp"

using contact::BouncingBall;
using contact::StepRule;
using contact::Vector3;
using generators::Random;
using oracle::Rational;
using oracle::Surd;
using rounding::u;
using support::contains;
using support::refusal;

namespace {

template <class S>
Vector3<S> vector(Random& random, int low, int high) {
  return Vector3<S>{S(random.magnitude(low, high)), S(random.magnitude(low, high)),
                    S(random.magnitude(low, high))};
}

/// |got − right| in every coordinate at most `room` times |v|, squared so that no root is needed.
template <class S>
bool within(const Vector3<S>& got, const oracle::Vector& right, const Rational& room,
            const Vector3<S>& v) {
  const oracle::Vector size = oracle::exact(v);
  const Rational allowed = room * room * size.dot(size);
  for (int i = 0; i < 3; ++i) {
    if (!std::isfinite(got(i))) return false;
    const Rational off = oracle::exact(got(i)) - right(i);
    if (off * off > allowed) return false;
  }
  return true;
}

/// The ball's times and places as numbers a + b √(v² + 2 g h).
struct ExactBall {
  Rational h, v, g, k, d;

  template <class S>
  explicit ExactBall(const BouncingBall<S>& ball)
      : h(oracle::exact(ball.height)),
        v(oracle::exact(ball.velocity)),
        g(oracle::exact(ball.gravity)),
        k(oracle::exact(ball.restitution)),
        d(v * v + 2 * g * h) {}

  Rational power(long long n) const {
    Rational result = 1;
    for (; n > 0; --n) result *= k;
    return result;
  }
  /// 1 + 2 (k + … + k^(n − 1))
  Rational series(long long n) const {
    Rational sum = 1;
    Rational term = 1;
    for (long long i = 1; i < n; ++i) {
      term *= k;
      sum += 2 * term;
    }
    return sum;
  }
  Surd impact(long long n) const { return {v / g, series(n) / g, d}; }
  Surd rest() const { return {v / g, (1 + k) / (1 - k) / g, d}; }
  Surd height(const Rational& t, long long n) const {
    if (n == 0) return {h + v * t - g * t * t / 2, 0, 0};
    const Rational p = t - v / g;
    const Rational q = series(n) / g;
    return {-power(n) * q * d - g * (p * p + q * q * d) / 2, power(n) * p + g * p * q, d};
  }
};

template <class S>
Rational error(S got, const Surd& right) {
  const double off = oracle::error(static_cast<double>(got), right);
  REQUIRE(std::isfinite(off));
  return oracle::exact(off);
}

template <class S>
BouncingBall<S> any_ball(Random& random, double least = 0.3) {
  const S g = S(random.uniform(0.5, 20));
  const S k = S(random.chance(0.1) ? 1 : random.uniform(least, 0.99));
  const S h = S(random.chance(0.2) ? 0 : random.uniform(0.01, 5));
  const S v = S(random.chance(0.3) ? 0 : random.uniform(-8, 8));
  return contact::bouncing_ball<S>(h, h == S(0) && !(v > S(0)) ? S(1) : v, g, k);
}

}  // namespace

TEMPLATE_TEST_CASE("what approaches is decided exactly", "", float, double) {
  using S = TestType;
  Random random(1501);
  int close = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vector3<S> n = vector<S>(random, -3, 3);
    Vector3<S> v = vector<S>(random, -3, 3);
    if (i % 2 == 0) {  // along the surface but for rounding
      v = n.cross(v);
    }
    if (i % 40 == 0) v *= S(std::ldexp(1.0, -130));
    const Rational dot = oracle::exact(v).dot(oracle::exact(n));
    REQUIRE(contact::approaches(v, n) == (dot < 0));
    close += abs(dot) < 8 * u<S>() * oracle::exact(S(v.norm() * n.norm()));
  }
  CHECK(close > 1000);
}

TEMPLATE_TEST_CASE("a bounce is v - (1 + k)(v.N)N for what approaches", "", float, double) {
  using S = TestType;
  Random random(1502);
  int left = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vector3<S> v = vector<S>(random, -4, 4);
    const Vector3<S> d = vector<S>(random, -4, 4);
    const Vector3<S> n = d.normalized();
    const S k = S(random.chance(0.2) ? random.integer(0, 1) : random.uniform());
    const oracle::Vector exact_v = oracle::exact(v);
    const oracle::Vector exact_d = oracle::exact(d);
    const oracle::Vector exact_n = oracle::exact(n);
    const Rational bounce = 1 + oracle::exact(k);

    const Vector3<S> got = contact::after_bounce(v, n, k);
    if (exact_v.dot(exact_n) >= 0) {
      REQUIRE(got == v);
      ++left;
    } else {
      const oracle::Vector right = exact_v - exact_n * Rational(bounce * exact_v.dot(exact_n));
      REQUIRE(within(got, right, 24 * u<S>(), v));
      // What the bounce must do, whatever the formula: the normal part comes back k times as fast,
      // and no kinetic energy is gained.
      const S roundoff = contact::tolerance::unit_roundoff<S>;
      REQUIRE(got.dot(n) >= -S(64) * roundoff * v.norm());
      REQUIRE(got.squaredNorm() <= v.squaredNorm() * (S(1) + S(128) * roundoff));
    }

    const Vector3<S> along = contact::after_bounce_along(v, d, k);
    if (exact_v.dot(exact_d) >= 0) {
      REQUIRE(along == v);
      continue;
    }
    const Rational share = bounce * exact_v.dot(exact_d) / exact_d.dot(exact_d);
    REQUIRE(within(along, oracle::Vector(exact_v - exact_d * share), 24 * u<S>(), v));
    // Sizes do not matter: powers of two change no bit.
    const int up = sizeof(S) == sizeof(float) ? 100 : 900;
    const Vector3<S> large = d * S(std::ldexp(1.0, up));
    const Vector3<S> small = d * S(std::ldexp(1.0, -up));
    REQUIRE(contact::after_bounce_along(v, large, k) == along);
    REQUIRE(contact::after_bounce_along(v, small, k) == along);
  }
  CHECK(left > 1500);
}

TEST_CASE("a bounce of rationals is exact") {
  const oracle::Vector v(3, -4, 5);
  const oracle::Vector d(0, 2, 0);
  const oracle::Vector got = contact::after_bounce_along<Rational>(v, d, Rational(1) / 3);
  CHECK(got == oracle::Vector(Rational(3), Rational(4) / 3, Rational(5)));
  CHECK(contact::after_bounce_along<Rational>(v, oracle::Vector(0, -1, 0), Rational(1)) == v);
}

TEST_CASE("the lecture's steel ball: 60 degrees from the wall, 259.8 N") {
  // Twice 3 kg times the normal part of 10 m/s, 5 √3 m/s, over 0.2 s: 150 √3 N.
  const Vector3<double> wall(1, 0, 0);
  const Vector3<double> v(-5 * std::sqrt(3.0), 5, 0);
  const Vector3<double> after = contact::after_bounce(v, wall, 1.0);
  const double force = contact::impulse_of_change(3.0, v, after).x() / 0.2;
  CHECK(std::abs(force * force - 67500) <= 1e-9);
  CHECK(after.y() == v.y());
  const double angle = contact::angle_from_normal(v, wall);
  CHECK(std::abs(contact::degrees(angle) - 30) <= 1e-13);
}

TEST_CASE("friction slows the slip, and at most stops it") {
  Random random(1503);
  int stopped = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vector3<double> v = vector<double>(random, -3, 3);
    const Vector3<double> n = vector<double>(random, -2, 2).normalized();
    const double k = random.uniform();
    const double mu = random.chance(0.2) ? 0 : random.uniform(0, 1.5);
    const double grip = random.chance(0.5) ? 1 : contact::solid_ball_grip<double>;
    const Vector3<double> got = contact::after_bounce_with_friction(v, n, k, mu, grip);
    if (!contact::approaches(v, n)) {
      REQUIRE(got == v);
      continue;
    }
    const double room = 60 * (1 + mu) * 0x1p-53 * v.norm();
    const double normal = -v.dot(n);
    REQUIRE(std::abs(got.dot(n) - k * normal) <= room);
    const Vector3<double> slip = v + n * normal;
    const Vector3<double> after = got - n * got.dot(n);
    REQUIRE(slip.cross(after).norm() <= 2 * room * v.norm());
    REQUIRE(after.dot(slip) >= -room * v.norm());
    const double taken = slip.norm() - after.norm();
    const double most = mu * (1 + k) * normal;
    if (most <= grip * slip.norm()) {
      REQUIRE(std::abs(taken - most) <= room);
    } else {
      REQUIRE(std::abs(taken - grip * slip.norm()) <= room);
      ++stopped;
    }
    if (mu == 0) REQUIRE((got - contact::after_bounce(v, n, k)).norm() <= room);
  }
  CHECK(stopped > 300);
  // Straight down there is nothing to slow.
  CHECK(contact::after_bounce_with_friction<double>({0, 0, -2}, {0, 0, 1}, 0.5, 0.7) ==
        Vector3<double>(0, 0, 1));
}

TEMPLATE_TEST_CASE("k is the root of the ratio of heights, also where the ratio is not a number",
                   "", float, double) {
  using S = TestType;
  Random random(1504);
  const int range = sizeof(S) == sizeof(float) ? 120 : 1000;
  for (int i = 0; i < 3000; ++i) {
    const S drop = std::abs(S(random.magnitude(-range, range)));
    const S rebound = std::abs(S(random.magnitude(-range, range)));
    const S k = contact::restitution_from_heights(drop, rebound);
    // |k − √q| ≤ 3 u √q, squared.
    const Rational q = oracle::exact(rebound) / oracle::exact(drop);
    const Rational square = oracle::exact(k) * oracle::exact(k);
    REQUIRE(square <= q * (1 + 3 * u<S>()) * (1 + 3 * u<S>()));
    REQUIRE(square >= q * (1 - 3 * u<S>()) * (1 - 3 * u<S>()));
  }
  const S least = std::numeric_limits<S>::denorm_min();
  const S most = std::numeric_limits<S>::max();
  CHECK(contact::restitution_from_heights(most, least) > S(0));
  CHECK(std::isfinite(contact::restitution_from_heights(S(1), most)));
  CHECK(std::isfinite(contact::restitution_from_heights(least, S(1))));
  CHECK(contact::restitution_from_heights(S(1), S(0)) == S(0));
  CHECK(contact::restitution_from_speeds(S(4), S(3)) == S(0.75));
}

TEST_CASE("what is no measurement is refused by name") {
  using contact::restitution_from_heights;
  using contact::restitution_from_speeds;
  static constexpr double infinite = std::numeric_limits<double>::infinity();
  CHECK(contains(refusal([] { restitution_from_heights(0.0, 1.0); }), "drop"));
  CHECK(contains(refusal([] { restitution_from_heights(1.0, -1.0); }), "rebound"));
  CHECK(contains(refusal([] { restitution_from_heights(1.0, std::nan("")); }), "rebound"));
  CHECK(contains(refusal([] { restitution_from_speeds(0.0, 1.0); }), "approach"));
  CHECK(contains(refusal([] { restitution_from_speeds(1.0, -1.0); }), "separation"));
  CHECK(contains(refusal([] { contact::bouncing_ball(-1.0, 0.0, 1.0, 0.5); }), "height"));
  CHECK(contains(refusal([] { contact::bouncing_ball(1.0, 0.0, 0.0, 0.5); }), "gravity"));
  CHECK(contains(refusal([] { contact::bouncing_ball(1.0, 0.0, 1.0, 1.1); }), "restitution"));
  CHECK(contains(refusal([] { contact::bouncing_ball(1.0, infinite, 1.0, 1.0); }), "velocity"));
  CHECK(contains(refusal([] { contact::drop_stacked(0.0, 1.0, 1.0, 1.0, 1.0); }), "mass"));
  CHECK(contains(refusal([] { contact::drop_stacked(1.0, 1.0, 1.0, 2.0, 1.0); }), "floor"));
  CHECK(contains(refusal([] { contact::drop_stacked(1.0, 1.0, 1.0, 1.0, -1.0); }), "balls"));
}

TEST_CASE("angles agree with intervals") {
  Random random(1505);
  for (int i = 0; i < 1500; ++i) {
    const double y = std::abs(random.magnitude(-30, 30));
    const double x = std::abs(random.magnitude(-30, 30));
    const auto right =
        oracle::enclose(atan(oracle::Interval(Rational(oracle::exact(y) / oracle::exact(x)), 128)));
    const double got = contact::arctangent(y, x);
    REQUIRE(right.error(got) <= 16 * 0x1p-53 * got);
  }
  CHECK(contact::arctangent(0.0, 0.0) == 0);
  CHECK(contact::arctangent(0.0, 2.0) == 0);
  CHECK(contact::arctangent(2.0, 0.0) == std::numbers::pi / 2);
  for (int i = 0; i < 500; ++i) {
    const Vector3<double> v = vector<double>(random, -3, 3);
    const Vector3<double> n = vector<double>(random, -3, 3).normalized();
    const double angle = contact::angle_from_normal(v, n);
    REQUIRE(std::abs(std::cos(angle) * v.norm() - std::abs(v.dot(n))) <= 64 * 0x1p-53 * v.norm());
    REQUIRE(contact::angle_from_normal(Vector3<double>(-v * 8), n) == angle);
  }
  CHECK(contact::angle_from_normal<double>({0, 0, 0}, {0, 0, 1}) == 0);
}

TEMPLATE_TEST_CASE("the times of impacts and of rest are as near as their comments say", "", float,
                   double) {
  using S = TestType;
  Random random(1506);
  for (int i = 0; i < 400; ++i) {
    const auto ball = any_ball<S>(random, i % 2 == 0 ? 0.3 : 0.0);
    const ExactBall exact(ball);
    REQUIRE(error(contact::impact_speed(ball), Surd{0, 1, exact.d}) <=
            4 * u<S>() * oracle::exact(contact::impact_speed(ball)) * (1 + 8 * u<S>()));
    const S first = contact::first_impact_time(ball);
    REQUIRE(error(first, exact.impact(1)) <= 8 * u<S>() * oracle::exact(first));
    for (const long long n : {2, 3, 7, 20, 61}) {
      const S time = contact::impact_time(ball, n);
      const S memory = std::min(S(n), S(1) / (S(1) - ball.restitution));
      const Rational factor = 16 + oracle::exact(S(2) * std::log2(S(n)) + S(2) * memory);
      REQUIRE(error(time, exact.impact(n)) <= factor * u<S>() * oracle::exact(time));
      // √d kⁿ and d k²ⁿ / (2 g); in float the slowest ones underflow.
      const S leaving = contact::leaving_speed(ball, n);
      if (leaving * leaving < S(1e-30)) continue;
      const Rational power = exact.power(n);
      REQUIRE(error(leaving, Surd{0, power, exact.d}) <=
              (S(n) + 6) * u<S>() * oracle::exact(leaving) * (1 + 8 * u<S>()));
      const S peak = contact::peak_height(ball, n);
      REQUIRE(abs(oracle::exact(peak) - exact.d * power * power / (2 * exact.g)) <=
              (2 * S(n) + 15) * u<S>() * oracle::exact(peak) * (1 + 8 * u<S>()));
    }
    if (ball.restitution < S(1)) {
      const S rest = contact::rest_time(ball);
      REQUIRE(error(rest, exact.rest()) <= 16 * u<S>() * oracle::exact(rest));
    } else {
      REQUIRE(std::isinf(contact::rest_time(ball)));
    }
  }
}

TEMPLATE_TEST_CASE("bounces are counted exactly, a last digit before an impact and after it", "",
                   float, double) {
  using S = TestType;
  Random random(1507);
  int at_impact = 0;
  for (int i = 0; i < 600; ++i) {
    const auto ball = any_ball<S>(random);
    const ExactBall exact(ball);
    const int n = random.integer(1, 25);
    S t = contact::impact_time(ball, n);
    for (int steps = random.integer(-3, 3); steps != 0; steps += steps > 0 ? -1 : 1) {
      t = std::nextafter(t, steps > 0 ? S(1e30) : S(0));
    }
    const Surd time{oracle::exact(t), 0, 0};
    const S got = contact::bounces_by(ball, t);
    if (ball.restitution < S(1) && oracle::compare(time, exact.rest()) >= 0) {
      REQUIRE(std::isinf(got));
      continue;
    }
    REQUIRE(std::isfinite(got));
    const auto count = static_cast<long long>(got);
    if (count > 0) REQUIRE(oracle::compare(exact.impact(count), time) <= 0);
    REQUIRE(oracle::compare(exact.impact(count + 1), time) > 0);
    at_impact += count == n;
  }
  CHECK(at_impact > 150);
}

TEST_CASE("bounces are counted exactly in the last digits before rest") {
  Random random(1523);
  int counted = 0;
  for (int i = 0; i < generators::tried(200); ++i) {
    const double speed = random.uniform(3, 8);
    const BouncingBall<double> ball{0, speed, 9.8125, random.uniform(0.5, 0.75)};
    const ExactBall exact(ball);
    double t = contact::rest_time(ball);
    for (int steps = random.integer(0, 6); steps > 0; --steps) t = std::nextafter(t, 0.0);
    const Surd time{oracle::exact(t), 0, 0};
    const double got = contact::bounces_by(ball, t);
    const bool rests = oracle::compare(time, exact.rest()) >= 0;
    REQUIRE(std::isinf(got) == rests);
    if (rests) continue;
    const auto count = static_cast<long long>(got);
    REQUIRE(oracle::compare(exact.impact(count), time) <= 0);
    REQUIRE(oracle::compare(exact.impact(count + 1), time) > 0);
    ++counted;
  }
  CHECK(counted > generators::tried(100));
}

TEST_CASE("counts and rest where everything is exact") {
  // Half a second to the floor and a quarter of the height after each bounce.
  const auto ball = contact::bouncing_ball(1.0, 0.0, 8.0, 0.5);
  CHECK(contact::impact_speed(ball) == 4);
  CHECK(contact::first_impact_time(ball) == 0.5);
  CHECK(contact::impact_time(ball, 2) == 1.0);
  CHECK(contact::impact_time(ball, 3) == 1.25);
  CHECK(contact::rest_time(ball) == 1.5);
  CHECK(contact::bounces_by(ball, 0.5) == 1);
  CHECK(contact::bounces_by(ball, std::nextafter(0.5, 0.0)) == 0);
  CHECK(contact::bounces_by(ball, 1.25) == 3);
  CHECK(std::isinf(contact::bounces_by(ball, 1.5)));
  // 2^-53 before the end: T_n = 1.5 - 2^(1 - n), so 53 bounces.
  CHECK(contact::bounces_by(ball, std::nextafter(1.5, 0.0)) == 53);
  CHECK(contact::bounce_at(ball, 0.75).height == 0.25);
  CHECK(contact::bounce_at(ball, 0.75).velocity == 0);
  CHECK(contact::leaving_speed(ball, 3) == 0.5);
  CHECK(contact::peak_height(ball, 1) == 0.25);
  CHECK(contact::peak_height(ball, 2) == 0.0625);
  CHECK(contact::bounce_at(ball, 2.0).resting);
  // k = 0: one impact, then rest. k = 1: as many as there is time for.
  CHECK(contact::bounces_by(contact::bouncing_ball(1.0, 0.0, 8.0, 0.0), 9.0) == 1);
  CHECK(contact::bounce_at(contact::bouncing_ball(1.0, 0.0, 8.0, 0.0), 0.5).resting);
  const auto forever = contact::bouncing_ball(1.0, 0.0, 8.0, 1.0);
  CHECK(contact::bounces_by(forever, 1e6) == 1e6);
  CHECK(contact::bounces_by(forever, 1e6 + 0.5) == 1e6 + 1);
  CHECK(contact::bounce_at(forever, 1e6).height == 1.0);
  // On the floor: at rest from the start.
  const auto lying = contact::bouncing_ball(0.0, 0.0, 8.0, 0.5);
  CHECK(contact::rest_time(lying) == 0);
  CHECK(contact::bounce_at(lying, 3.0).resting);
  CHECK(contact::bounce_at(lying, 3.0).bounces == 1);
}

TEST_CASE("the ball is where fractions and roots say") {
  Random random(1508);
  for (int i = 0; i < 600; ++i) {
    const auto ball = any_ball<double>(random);
    const ExactBall exact(ball);
    const double w = contact::impact_speed(ball);
    const double end = std::min(contact::impact_time(ball, 30), contact::rest_time(ball));
    const double t = random.uniform(0, end);
    const auto got = contact::bounce_at(ball, t);
    REQUIRE(std::isfinite(got.bounces));
    const auto n = static_cast<long long>(got.bounces);
    const double u = 0x1p-53;
    const double memory = std::min(static_cast<double>(n), 1 / (1 - ball.restitution));
    const double factor = 16 + 2 * std::log2(1.0 + static_cast<double>(n)) + 2 * memory;
    const double room =
        n == 0 ? 8 * u * (ball.height + std::abs(ball.velocity) * t + ball.gravity * t * t / 2)
               : 4 * factor * u * w * t;
    REQUIRE(oracle::error(got.height, exact.height(oracle::exact(t), n)) <= room);
    // Flight by flight comes to the same.
    const auto followed = contact::follow_bounces(ball, t, 0.0);
    REQUIRE(std::abs(followed.height - got.height) <=
            (3.0 * static_cast<double>(n) + 40) * u * w * t);
  }
}

TEST_CASE("energy never grows from bounce to bounce, and falls by k squared") {
  Random random(1509);
  for (int i = 0; i < 300; ++i) {
    const auto ball = any_ball<double>(random);
    const double t1 = contact::first_impact_time(ball);
    const double t2 = contact::impact_time(ball, 2);
    const auto energy = [&ball](const contact::BounceState<double>& s) {
      return s.velocity * s.velocity / 2 + ball.gravity * s.height;
    };
    const double before = energy(contact::bounce_at(ball, t1 / 2));
    const double after = energy(contact::bounce_at(ball, t1 + (t2 - t1) / 3));
    const double k = ball.restitution;
    REQUIRE(std::abs(after - k * k * before) <= 1e-13 * before);
  }
}

TEST_CASE("resting too early costs at most the height that was asked for") {
  Random random(1510);
  int early = 0;
  for (int i = 0; i < 500; ++i) {
    auto ball = any_ball<double>(random);
    ball.restitution = std::min(ball.restitution, 0.9);
    const double allowed = 0.001;
    const double w = contact::rest_speed(allowed, ball.gravity);
    const double t = random.uniform(0, 1.1 * contact::rest_time(ball));
    const auto cut = contact::follow_bounces(ball, t, w);
    const auto exact = contact::bounce_at(ball, t);
    REQUIRE(std::abs(cut.height - exact.height) <= allowed * (1 + 1e-9));
    early += cut.resting && !exact.resting;
    // Without a rest speed the clock ends it.
    const auto endless = contact::follow_bounces(ball, 2 * contact::rest_time(ball), 0.0);
    REQUIRE(endless.resting);
    REQUIRE(endless.bounces < 60 / std::log2(1 / ball.restitution) + 5);
  }
  CHECK(early > 10);
}

TEST_CASE("an early rest begins at the first impact that is left slowly enough") {
  // It arrives with 4 m/s and leaves with 2, 1, 1/2 …
  const auto ball = contact::bouncing_ball(1.0, 0.0, 8.0, 0.5);
  const auto rest = [&ball](double speed) { return contact::early_rest(ball, speed); };
  CHECK(rest(9.0).impacts == 1);
  CHECK(rest(2.0).impacts == 1);
  CHECK(rest(std::nextafter(2.0, 0.0)).impacts == 2);
  CHECK(rest(0.5).impacts == 3);
  CHECK(rest(0.5).time == 1.25);
  CHECK(rest(0x1p-40).impacts == 42);
  CHECK(std::isinf(rest(0.0).impacts));
  CHECK(rest(0.0).time == 1.5);
  const auto forever = contact::bouncing_ball(1.0, 0.0, 8.0, 1.0);
  CHECK(std::isinf(contact::early_rest(forever, 3.0).impacts));
  CHECK(std::isinf(contact::early_rest(forever, 3.0).time));
  CHECK(contact::early_rest(forever, 4.0).impacts == 1);
  const auto falls_dead = contact::bouncing_ball(1.0, 0.0, 8.0, 0.0);
  CHECK(contact::early_rest(falls_dead, 0.0).impacts == 1);
  CHECK(contact::early_rest(falls_dead, 0.0).time == 0.5);
  CHECK(contact::early_rest(contact::bouncing_ball(0.0, 0.0, 8.0, 0.5), 0.0).impacts == 1);
  // So slow a loss that nobody could follow it.
  const auto patient = contact::bouncing_ball(1.0, 0.0, 8.0, std::nextafter(1.0, 0.0));
  CHECK(contact::early_rest(patient, 2.0).impacts > 6e15);
  CHECK(contact::early_rest(patient, 2.0).impacts < 6.5e15);

  Random random(1520);
  int many = 0;
  for (int i = 0; i < 500; ++i) {
    auto some = any_ball<double>(random);
    some.restitution = std::min(some.restitution, 0.9);
    const double w = contact::rest_speed(0.001, some.gravity);
    const auto early = contact::early_rest(some, w);
    const auto followed = contact::follow_bounces(some, 2 * contact::rest_time(some), w);
    if (std::abs(contact::leaving_speed(some, static_cast<long long>(early.impacts)) - w) <
        1e-9 * w) {
      continue;
    }
    REQUIRE(early.impacts == followed.bounces);
    many += early.impacts > 3;
  }
  CHECK(many > 100);
}

TEST_CASE("which step rule gains, and which loses") {
  Random random(1511);
  int lecture_gains = 0;
  int lecture_loses = 0;
  for (int i = 0; i < 300; ++i) {
    const auto ball = contact::bouncing_ball(random.uniform(0.5, 3), 0.0, 9.81, 1.0);
    const double dt = random.uniform(0.004, 0.02);
    const double top = 9.81 * ball.height;
    const auto until_bounce = [&](StepRule rule) {
      contact::BounceState<double> state{ball.height, 0, 0, false};
      while (state.bounces == 0) state = contact::bounce_step(state, ball, dt, rule);
      return state;
    };
    const auto energy = [](const contact::BounceState<double>& s) {
      return s.velocity * s.velocity / 2 + 9.81 * s.height;
    };
    // The end of the step is later than the impact, so its velocity is larger.
    REQUIRE(energy(until_bounce(StepRule::end_velocity)) > top);
    REQUIRE(std::abs(energy(until_bounce(StepRule::impact_velocity)) - top) <= 1e-12 * top);
    // Euler's steps keep v²/2 + g x − g dt v/2. With the impact a share s into the step, and w the
    // new speed, the lecture's loop changes that by g dt w (1 − 2 s).
    contact::BounceState<double> state{ball.height, 0, 0, false};
    contact::BounceState<double> before = state;
    while (state.bounces == 0) {
      before = state;
      state = contact::bounce_step(state, ball, dt, StepRule::new_velocity);
    }
    const auto kept = [&](const contact::BounceState<double>& s) {
      return energy(s) - 9.81 * dt * s.velocity / 2;
    };
    const double share = before.height / (state.velocity * dt);
    const double change = 9.81 * dt * state.velocity * (1 - 2 * share);
    REQUIRE(std::abs(kept(state) - kept(before) - change) <= 1e-11 * top);
    (change > 0 ? lecture_gains : lecture_loses) += 1;
  }
  CHECK(lecture_gains > 90);
  CHECK(lecture_loses > 90);
}

TEST_CASE("steps with the impact velocity land where the formula does, in any number of steps") {
  Random random(1512);
  for (int i = 0; i < 200; ++i) {
    const auto ball = any_ball<double>(random);
    const double dt = random.uniform(0.005, 0.5);
    const int steps = random.integer(1, 40);
    const auto stepped = contact::bounce_in_steps(ball, dt, steps, StepRule::impact_velocity);
    const double t = steps * dt;
    // Near an impact the two may count it on different sides of t; far from it they agree.
    const auto exact = contact::bounce_at(ball, t);
    REQUIRE(std::abs(stepped.height - exact.height) <=
            1e-11 * (1 + contact::impact_speed(ball) * t));
  }
}

TEST_CASE("a flip without a test for approach sinks through the floor") {
  const auto ball = contact::bouncing_ball(1.0, 0.0, 9.81, 0.5);
  const auto sunk = contact::bounce_in_steps(ball, 1.0 / 60, 600, StepRule::flip_below);
  CHECK(sunk.height < -0.01);
  CHECK(contact::bounce_in_steps(ball, 1.0 / 60, 600, StepRule::clamp).height >= 0);
}

TEST_CASE("two balls on each other obey momentum and restitution, in fractions") {
  Random random(1513);
  for (int i = 0; i < 500; ++i) {
    const Rational m = oracle::exact(std::abs(random.magnitude(-8, 8)));
    const Rational n = oracle::exact(std::abs(random.magnitude(-8, 8)));
    const Rational v = oracle::exact(random.uniform(0.1, 9));
    const Rational floor = oracle::exact(random.uniform());
    const Rational balls = oracle::exact(random.uniform());
    const auto got = contact::drop_stacked<Rational>(m, n, v, floor, balls);
    REQUIRE(got.lower_from_floor == floor * v);
    REQUIRE(m * got.lower + n * got.upper == m * floor * v - n * v);
    REQUIRE(got.upper - got.lower == balls * (floor * v + v));
  }
  const auto limit = contact::drop_stacked(1e12, 1.0, 1.0, 1.0, 1.0);
  CHECK(std::abs(limit.upper - 3) < 1e-11);
  const auto dead = contact::drop_stacked(3.0, 1.0, 1.0, 1.0, 1.0);
  CHECK(dead.lower == 0);
  CHECK(dead.upper == 2);
  const auto extreme = contact::drop_stacked(1e300, 1e300, 1.0, 1.0, 0.5);
  CHECK(std::isfinite(extreme.upper));
}

TEST_CASE("no finite ball makes a NaN") {
  Random random(1514);
  for (int i = 0; i < 3000; ++i) {
    const double h = random.chance(0.2) ? 0 : std::abs(random.magnitude(-1070, 1000));
    const double v = random.chance(0.2) ? 0 : random.magnitude(-1070, 1000);
    const double g = std::abs(random.magnitude(-1070, 1000));
    const double k = random.chance(0.3) ? random.integer(0, 1)
                                        : std::min(1.0, std::abs(random.magnitude(-60, -1)));
    const auto ball = contact::bouncing_ball(h, v, g, k);
    const double t = random.chance(0.1) ? 0 : std::abs(random.magnitude(-1070, 1022));
    REQUIRE_FALSE(std::isnan(contact::impact_speed(ball)));
    REQUIRE_FALSE(std::isnan(contact::first_impact_time(ball)));
    REQUIRE_FALSE(std::isnan(contact::rest_time(ball)));
    const auto state = contact::bounce_at(ball, t);
    REQUIRE_FALSE(std::isnan(state.height));
    REQUIRE_FALSE(std::isnan(state.velocity));
    REQUIRE(state.bounces >= 0);
    const Vector3<double> a = vector<double>(random, -1070, 1020);
    const Vector3<double> b = vector<double>(random, -1070, 1020);
    REQUIRE_FALSE(contact::after_bounce_along(a, b, k).hasNaN());
  }
}
