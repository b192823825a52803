// Hard balls: times of contact against exact roots. u is the unit roundoff.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/events/earliest_queue.hpp>
#include <contact/events/hard_sphere_times.hpp>
#include <optional>
#include <vector>

#include "hard_setups.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

using contact::Column;
using contact::Vector3;
using generators::Random;
using generators::tried;
using hard_setups::in_cube;
using hard_setups::u;
using oracle::Rational;

TEST_CASE("two balls meet when the exact roots say, far from grazing") {
  Random random(1);
  int met = 0;
  for (int n = 0; n < tried(20000); ++n) {
    const Vector3<double> d = in_cube(random, 3);
    const Vector3<double> w = in_cube(random, 5);
    const double reach = random.uniform(0.1, 2);
    const oracle::Vector de = oracle::exact(d);
    const oracle::Vector we = oracle::exact(w);
    const Rational r = oracle::exact(reach);
    const oracle::Quadratic q{we.dot(we), 2 * de.dot(we), de.dot(de) - r * r};
    const double got = contact::meeting<3>(d, w, reach);
    const double depth = oracle::nearest(Rational(q.discriminant() / (q.a * r * r)));
    // The discriminant 4 w² (R² − p²) is off by less than 64 u |d|² w²: nearer to grazing than
    // this, double precision cannot decide.
    if (std::abs(depth) < 1e-10) continue;
    if (q.c > 0 && q.b < 0 && depth > 0) {
      const oracle::Surd right = q.roots().front();
      // The error of the root is that of the discriminant, times root / depth.
      const double room = 256 * u * (1 + d.squaredNorm() / (reach * reach * depth)) * got;
      REQUIRE(oracle::error(got, right) <= room);
      ++met;
    } else if (q.c <= 0 && q.b < 0) {
      REQUIRE(got == 0);
    } else {
      REQUIRE(got == contact::never);
    }
    REQUIRE(contact::meeting<3>(-d, -w, reach) == got);
  }
  CHECK(met > tried(500));
}

TEST_CASE("on a line and in a plane meetings are those of space, bit for bit") {
  Random random(2);
  for (int n = 0; n < tried(5000); ++n) {
    const double reach = random.uniform(0.1, 2);
    for (int k = 0; k < 3; ++k) {
      Vector3<double> d = in_cube(random, 5);
      Vector3<double> w = in_cube(random, 5);
      d(k) = w(k) = 0;
      const int a = k == 0 ? 1 : 0;
      const int b = k == 2 ? 1 : 2;
      const double in_space = contact::meeting<3>(d, w, reach);
      REQUIRE(contact::meeting<2>(Column<2>(d(a), d(b)), Column<2>(w(a), w(b)), reach) == in_space);
      d(a) = w(a) = 0;
      REQUIRE(contact::meeting<1>(Column<1>(d(b)), Column<1>(w(b)), reach) ==
              contact::meeting<3>(d, w, reach));
    }
  }
}

TEST_CASE("a plane is reached when the exact roots say, and the speed is that of the energy") {
  Random random(3);
  int reached = 0;
  for (int n = 0; n < tried(20000); ++n) {
    const double gap = random.chance(0.1) ? 0 : random.uniform(0, 10);
    const double v = random.uniform(-10, 10);
    const double a = random.chance(0.2) ? 0 : random.uniform(-10, 10);
    const auto got = contact::arrival_at_plane(gap, v, a);
    const oracle::Quadratic q{oracle::exact(a) / 2, oracle::exact(v), oracle::exact(gap)};
    std::optional<oracle::Surd> right;
    if (gap == 0 && v < 0) {
      REQUIRE(got.after == 0);
      REQUIRE(got.speed == -v);
      continue;
    }
    for (const oracle::Surd& root : q.roots()) {
      // Of the roots, the first at which the distance decreases: its rate there, v + a t, is
      // negative.
      const oracle::Surd rate{oracle::exact(v) + oracle::exact(a) * root.a,
                              oracle::exact(a) * root.b, root.d};
      if (!right && oracle::sign(root) >= 0 && oracle::sign(rate) < 0) right = root;
    }
    if (!right) {
      REQUIRE(got.after == contact::never);
      continue;
    }
    ++reached;
    const double energy = v * v - 2 * a * gap;
    const double size = v * v + 2 * std::abs(a) * gap;
    // √ of an energy that is off by 4 u of its size; where it cancels, that much more.
    const double worse = 1 + size / energy;
    REQUIRE(oracle::error(got.after, *right) <= 16 * u * worse * got.after);
    const oracle::Surd speed{
        0, 1, oracle::exact(v) * oracle::exact(v) - 2 * oracle::exact(a) * oracle::exact(gap)};
    REQUIRE(oracle::error(got.speed, speed) <= 8 * u * worse * got.speed);
  }
  CHECK(reached > tried(8000));
  // A ball that leaves with s comes back with s, to the last bit.
  for (int n = 0; n < tried(5000); ++n) {
    const double s = random.uniform(0, 100);
    REQUIRE(contact::arrival_at_plane(0, s, -random.uniform(0.1, 20)).speed == s);
  }
}

TEST_CASE(
    "where one path is a parabola, the balls meet at the first zero at which their distance "
    "decreases") {
  Random random(4);
  int met = 0;
  for (int n = 0; n < tried(3000); ++n) {
    const Vector3<double> d = in_cube(random, 3);
    const Vector3<double> w = in_cube(random, 5);
    const Vector3<double> a{0, 0, random.uniform(-12, 12)};
    const double reach = random.uniform(0.1, 2);
    if (d.norm() <= reach) continue;
    const double got = contact::accelerated_meeting<3>(d, w, a, reach, false);
    // In fractions: |d + w t + a t²/2|² − R².
    const auto f = [&](const Rational& t) {
      const oracle::Vector x =
          oracle::ballistic(oracle::exact(d), oracle::exact(w), oracle::exact(a), t);
      return Rational(x.dot(x) - oracle::exact(reach) * oracle::exact(reach));
    };
    const double last = got == contact::never ? 20 : got;
    const double size = d.squaredNorm() + w.squaredNorm() * last * last +
                        a.squaredNorm() * last * last * last * last + reach * reach;
    // No zero is missed: up to there f is positive at every sample, except for rounding.
    for (int k = 0; k < 40; ++k)
      REQUIRE(oracle::nearest(f(oracle::exact(last) * k / 40)) > -64 * u * size);
    if (got == contact::never) continue;
    ++met;
    REQUIRE(std::abs(oracle::nearest(f(oracle::exact(got)))) <= 64 * u * size);
  }
  CHECK(met > tried(3000) / 30);
  // Thrown vertically upwards beside it, and back onto it: closed form 2 v / g.
  const double back = contact::accelerated_meeting<3>({0, 0, 1}, {0, 0, 5}, {0, 0, -10}, 1, true);
  CHECK(std::abs(back - 1) <= 4 * u);
}

TEST_CASE("the tournament's winner is the earliest, whatever changes") {
  Random random(5);
  for (int n = 0; n < tried(60); ++n) {
    const auto slots = static_cast<std::size_t>(random.integer(1, 40));
    std::vector<int> keys(slots, 0);
    const auto before = [&](std::size_t i, std::size_t k) {
      return std::pair(keys[i], i) < std::pair(keys[k], k);
    };
    contact::EarliestQueue queue(slots);
    queue.play_all(before);
    for (int change = 0; change < 300; ++change) {
      const auto slot = static_cast<std::size_t>(random.integer(0, static_cast<int>(slots) - 1));
      keys[slot] = random.integer(-20, 20);
      queue.update(slot, before);
      std::size_t least = 0;
      for (std::size_t i = 1; i < slots; ++i)
        if (before(i, least)) least = i;
      REQUIRE(queue.first() == least);
    }
  }
}
