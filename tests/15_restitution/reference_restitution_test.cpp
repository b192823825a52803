// restitution.hpp and rebound_angle.hpp against fractions, with one square root where there is one.
// u is the unit roundoff of the type. A bound that a comment of the reference gives is tested as it
// stands, without an allowance.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/bouncing.hpp>
#include <contact/impulse.hpp>
#include <contact/rebound_angle.hpp>
#include <contact/restitution.hpp>
#include <contact/stacked_drop.hpp>
#include <limits>
#include <numbers>

#include "reference.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/refusal.hpp"
#include "support/rounding.hpp"

using contact::Vector3;
using generators::Random;
using oracle::Rational;
using reference::error;
using reference::vector;
using rounding::u;
using support::contains;
using support::refusal;

namespace {

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

}  // namespace

TEMPLATE_TEST_CASE("approach is decided exactly", "", float, double) {
  using S = TestType;
  Random random(1501);
  int close = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vector3<S> n = vector<S>(random, -3, 3);
    Vector3<S> v = vector<S>(random, -3, 3);
    if (i % 2 == 0) {  // tangential up to rounding
      v = n.cross(v);
    }
    if (i % 40 == 0) v *= S(std::ldexp(1.0, -130));
    const Rational dot = oracle::exact(v).dot(oracle::exact(n));
    REQUIRE(contact::approaches(v, n) == (dot < 0));
    close += abs(dot) < 8 * u<S>() * oracle::exact(S(v.norm() * n.norm()));
  }
  CHECK(close > 1000);
}

TEMPLATE_TEST_CASE("a bounce is v - (1 + k)(v.N)N for approaching bodies", "", float, double) {
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
      // Whatever the formula: the normal component is multiplied by −k, and no kinetic energy is
      // gained.
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
    // Scaling by powers of two changes no bit.
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
  // Twice 3 kg times the normal component of 10 m/s, 5 √3 m/s, over 0.2 s: 150 √3 N.
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
  // Vertically there is no slip.
  CHECK(contact::after_bounce_with_friction<double>({0, 0, -2}, {0, 0, 1}, 0.5, 0.7) ==
        Vector3<double>(0, 0, 1));
}

TEMPLATE_TEST_CASE("k is the root of the ratio of heights, also where the ratio overflows", "",
                   float, double) {
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

TEST_CASE("invalid measurements are refused, naming the argument") {
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

TEST_CASE("two balls dropped together obey momentum and restitution, in exact fractions") {
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
