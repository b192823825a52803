// impulse.hpp against rational arithmetic on the stored numbers (class (a) of the oracle). u is the
// unit roundoff of the type. A bound in a comment of the reference is tested without an
// allowance.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/impulse.hpp>
#include <limits>
#include <vector>

#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/rounding.hpp"

using contact::ForceCurve;
using contact::Vector3;
using generators::Random;
using oracle::Rational;
using rounding::error;
using rounding::gamma;
using rounding::nearest;
using rounding::u;

TEMPLATE_TEST_CASE("the impulse of a curve is the area under it", "", float, double) {
  using S = TestType;
  Random random(1208);
  for (int i = 0; i < 2500; ++i) {
    std::vector<S> time{static_cast<S>(random.uniform(-1, 1))};
    std::vector<Vector3<S>> force;
    const int n = random.integer(2, 40);
    while (static_cast<int>(time.size()) < n) {
      const S later = time.back() + static_cast<S>(random.uniform(0.001, 0.1));
      time.push_back(later);
    }
    for (int k = 0; k < n; ++k) {
      force.push_back(generators::rounded<S>(Vector3<double>{
          random.uniform(-900, 900), random.magnitude(-10, 10), random.uniform(0, 1)}));
    }
    const ForceCurve<S> curve = contact::force_curve(time, force);
    const auto fast = contact::impulse(curve);
    const auto once = contact::impulse_exactly(curve);
    const auto mean = contact::average_force(curve);
    const Rational duration = oracle::exact(time.back()) - oracle::exact(time.front());
    const Rational many = gamma<S>(n - 2) * gamma<S>(n - 2);  // n − 1 trapezoids
    for (int k = 0; k < 3; ++k) {
      Rational area = 0;
      Rational size = 0;
      for (std::size_t p = 0; p + 1 < time.size(); ++p) {
        const Rational piece = (oracle::exact(time[p + 1]) - oracle::exact(time[p])) *
                               (oracle::exact(force[p](k)) + oracle::exact(force[p + 1](k))) / 2;
        area += piece;
        size += abs(piece);
      }
      REQUIRE(error(fast(k), area) <= (5 * u<S>() + many) * size);
      REQUIRE(once(k) == nearest<S>(area));
      REQUIRE(error(mean(k), area / duration) <= (8 * u<S>() + many) * size / duration);
    }
    CHECK(contact::impulse_until(curve, time.front()) == Vector3<S>::Zero());
    CHECK(contact::impulse_until(curve, time.back()) == fast);
  }
}

TEST_CASE("the error for very many samples exceeds a few roundings and satisfies its bound") {
  const int pieces = 200000;
  std::vector<float> time;
  for (int i = 0; i <= pieces; ++i) time.push_back(static_cast<float>(i));
  const std::vector<Vector3<float>> force(time.size(), Vector3<float>(0.1f, 0, 0));
  const float got = contact::impulse(contact::force_curve(time, force)).x();
  const Rational right = pieces * oracle::exact(0.1f);
  CHECK(error(got, right) > 5 * u<float>() * right);
  CHECK(error(got, right) <=
        (5 * u<float>() + gamma<float>(pieces - 1) * gamma<float>(pieces - 1)) * right);
}

TEST_CASE("the impulse up to a time is the area up to that time") {
  // A triangle of 6 ms and 4000 N: 12 N·s, of which a quarter by 3/√2 ms.
  const auto curve =
      contact::force_curve<double>({0, 0.003, 0.006}, {{0, 0, 0}, {4000, 0, 0}, {0, 0, 0}});
  CHECK(std::abs(contact::impulse(curve).x() - 12) < 1e-14);
  CHECK(std::abs(contact::average_force(curve).x() - 2000) < 1e-11);
  CHECK(std::abs(contact::impulse_until(curve, 0.003).x() - 6) < 1e-14);
  CHECK(std::abs(contact::impulse_until(curve, 0.003 / std::sqrt(2.0)).x() - 3) < 1e-13);
  CHECK(contact::impulse_until(curve, -1.0).x() == 0);
  CHECK(contact::impulse_until(curve, 9.0) == contact::impulse(curve));
}

TEST_CASE("impulse and average force are finite if only an intermediate result overflows") {
  const double big = std::numeric_limits<double>::max();
  const auto wide = contact::force_curve<double>({-big, big}, {{1, 2, 0}, {1, -2, 0}});
  CHECK(contact::average_force(wide) == Vector3<double>(1, 0, 0));
  const auto strong = contact::force_curve<double>({0, 0.25}, {{big, 0, 0}, {big, -big, 0}});
  CHECK(contact::impulse(strong).x() == big / 4);
  CHECK(contact::average_force(strong).x() == big);
  CHECK(contact::average_force(strong).y() == -big / 2);
}
