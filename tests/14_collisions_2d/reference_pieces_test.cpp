// momentum_triangle.hpp and pieces.hpp against rational arithmetic on the stored numbers, with one
// square root where there is one. u is the unit roundoff of the type. A bound that a comment of the
// reference gives is tested as it stands, without an allowance.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/disc_collision.hpp>
#include <contact/momentum_triangle.hpp>
#include <contact/pieces.hpp>
#include <stdexcept>

#include "reference.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/rounding.hpp"

using contact::Vector2;
using contact::Vector3;
using generators::Random;
using oracle::Rational;
using reference::vector_of;
using rounding::error;
using rounding::u;

TEMPLATE_TEST_CASE("shares of a momentum are those of rational arithmetic", "", float, double) {
  using S = TestType;
  Random random(6);
  int parallel = 0;
  for (int i = 0; i < 600; ++i) {
    Vector2<S> total = vector_of<S>(random, 9);
    Vector2<S> a = vector_of<S>(random, 1);
    Vector2<S> b = vector_of<S>(random, 1);
    if (i % 4 == 1) b = a * S(random.integer(-3, 3));
    if (i % 4 == 2) b = Vector2<S>{std::nextafter(a.x(), S(2)), a.y()};
    if (i % 4 == 3) {
      a = contact::detail::times_power<S>(a, -60);
      total = contact::detail::times_power<S>(total, 90);
    }
    if (b == Vector2<S>::Zero()) continue;
    const auto cross = [](const Vector2<S>& x, const Vector2<S>& y) {
      return Rational(oracle::exact(x.x()) * oracle::exact(y.y()) -
                      oracle::exact(x.y()) * oracle::exact(y.x()));
    };
    const Rational sine = cross(a, b);
    const auto got = contact::share_momentum(total, a, b);
    REQUIRE(got.has_value() == (sine != 0));
    if (!got) {
      ++parallel;
      continue;
    }
    for (int k = 0; k < 2; ++k) {
      const Rational right_a = cross(total, b) / sine * oracle::exact(a(k));
      const Rational right_b = cross(a, total) / sine * oracle::exact(b(k));
      CHECK(error(got->a(k), right_a) <= 10 * u<S>() * abs(right_a));
      CHECK(error(got->b(k), right_b) <= 10 * u<S>() * abs(right_b));
    }
  }
  CHECK(parallel > 50);
  const auto none = contact::share_momentum<Rational>({1, 0}, {1, 2}, {2, 4});
  CHECK_FALSE(none);
  const auto exact = contact::share_momentum<Rational>({1, 0}, {1, 1}, {1, -2});
  REQUIRE(exact);
  CHECK(exact->a + exact->b == Vector2<Rational>(1, 0));
}

TEST_CASE("pieces that fly apart conserve momentum and gain the energy") {
  Random random(7);
  for (int i = 0; i < 300; ++i) {
    const double m1 = random.uniform(0.1, 240);
    const double m2 = random.uniform(0.1, 9);
    const double energy = i % 5 == 0 ? 0 : random.uniform(0, 1e3);
    const Vector3<double> v{random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)};
    const Vector3<double> way{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.1, 1)};
    const auto after = contact::fly_apart<double>(m1, m2, v, energy, way);
    const Rational a = oracle::exact(m1);
    const Rational b = oracle::exact(m2);
    Rational gained = 0;
    Rational size = 0;
    for (int k = 0; k < 3; ++k) {
      const Rational before = oracle::exact(v(k));
      const Rational first = oracle::exact(after.first(k));
      const Rational second = oracle::exact(after.second(k));
      const Rational scale = a * (abs(before) + abs(first)) + b * (abs(before) + abs(second));
      CHECK(abs(a * first + b * second - (a + b) * before) <= 16 * u<double>() * scale);
      gained += (a * first * first + b * second * second - (a + b) * before * before) / 2;
      size += a * first * first + b * second * second + (a + b) * before * before;
    }
    // Velocities are off by a few u each, energies by twice as much.
    CHECK(abs(gained - oracle::exact(energy)) <= 32 * u<double>() * (size + oracle::exact(energy)));
    const Vector3<double> apart = after.second - after.first;
    CHECK(std::abs(contact::energy_apart<double>(m1, m2, apart) - energy) <=
          64 * 0x1p-53 * (energy + oracle::nearest(size)));
  }
  CHECK_THROWS_AS(contact::fly_apart<double>(1, 1, {0, 0, 0}, -1, {1, 0, 0}),
                  std::invalid_argument);
  CHECK_THROWS_AS(contact::fly_apart<double>(1, 1, {0, 0, 0}, 1, {0, 0, 0}), std::invalid_argument);
  CHECK_THROWS_AS(contact::fly_apart<double>(0, 1, {0, 0, 0}, 1, {1, 0, 0}), std::invalid_argument);
}
