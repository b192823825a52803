// bouncing.hpp and fixed_step_bounce.hpp against fractions, with one square root where there is
// one. u is the unit roundoff of the type. A bound that a comment of the reference gives is tested
// as it stands, without an allowance.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>
#include <contact/bouncing.hpp>
#include <contact/fixed_step_bounce.hpp>
#include <contact/restitution.hpp>

#include "reference.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/rounding.hpp"

using contact::BouncingBall;
using contact::StepRule;
using contact::Vector3;
using generators::Random;
using oracle::Rational;
using oracle::Surd;
using reference::error;
using reference::vector;
using rounding::u;

namespace {

/// The ball's times and heights as numbers a + b √(v² + 2 g h).
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
BouncingBall<S> any_ball(Random& random, double least = 0.3) {
  const S g = S(random.uniform(0.5, 20));
  const S k = S(random.chance(0.1) ? 1 : random.uniform(least, 0.99));
  const S h = S(random.chance(0.2) ? 0 : random.uniform(0.01, 5));
  const S v = S(random.chance(0.3) ? 0 : random.uniform(-8, 8));
  return contact::bouncing_ball<S>(h, h == S(0) && !(v > S(0)) ? S(1) : v, g, k);
}

}  // namespace

TEMPLATE_TEST_CASE("the times of impacts and of rest are within their documented errors", "", float,
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
      // √d kⁿ and d k²ⁿ / (2 g); in float the smallest ones underflow.
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

TEMPLATE_TEST_CASE("bounces are counted exactly one ulp before and after an impact", "", float,
                   double) {
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

TEST_CASE("bounces are counted exactly in the last ulps before rest") {
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
  // k = 0: one impact, then rest. k = 1: as many as fit into the time.
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

TEST_CASE("the height agrees with fractions and one square root") {
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
    // Flight by flight agrees.
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

TEST_CASE("an early rest has at most the error of height that was asked for") {
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
    // Without a rest speed the loop ends when the time no longer grows.
    const auto endless = contact::follow_bounces(ball, 2 * contact::rest_time(ball), 0.0);
    REQUIRE(endless.resting);
    REQUIRE(endless.bounces < 60 / std::log2(1 / ball.restitution) + 5);
  }
  CHECK(early > 10);
}

TEST_CASE("an early rest begins at the first impact with a small enough leaving speed") {
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
  // A loss too small to be followed flight by flight.
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
    // Semi-implicit Euler conserves v²/2 + g x − g dt v/2. With the impact at the fraction s of the
    // step, and w the new speed, the lecture's loop changes that by g dt w (1 − 2 s).
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

TEST_CASE("steps with the impact velocity agree with the formula for any number of steps") {
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

TEST_CASE("a ball that is flipped without a test for approach sinks through the floor") {
  const auto ball = contact::bouncing_ball(1.0, 0.0, 9.81, 0.5);
  const auto sunk = contact::bounce_in_steps(ball, 1.0 / 60, 600, StepRule::flip_below);
  CHECK(sunk.height < -0.01);
  CHECK(contact::bounce_in_steps(ball, 1.0 / 60, 600, StepRule::clamp).height >= 0);
}

TEST_CASE("a ball whose height is kept below the floor sinks in spite of a test for approach") {
  const double dt = 1.0 / 64;
  const double k = GENERATE(0.25, 0.5, 0.875);
  double height = 1, velocity = 0;
  for (int step = 0; step < 1280; ++step) {
    velocity -= 8 * dt;
    height += velocity * dt;
    if (height < 0 && velocity < 0) velocity *= -k;
  }
  CHECK(height < -1);
}

TEST_CASE("no finite ball gives a NaN") {
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
