// ballistic.hpp: flights and closing times, against fractions with one square root.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/ballistic.hpp>
#include <contact/integrators.hpp>
#include <limits>

#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/rounding.hpp"

using contact::MotionState;
using generators::Random;
using oracle::Rational;
using oracle::Surd;
using rounding::u;

TEMPLATE_TEST_CASE("a flight of any length has an error of a few u of its terms", "", float,
                   double) {
  using S = TestType;
  Random random(1906);
  for (int i = 0; i < 2000; ++i) {
    const S x = S(random.magnitude(-6, 6));
    const S v = S(random.magnitude(-6, 6));
    const S a = S(random.magnitude(-6, 6));
    const S t = S(std::abs(random.magnitude(-6, 6)));
    const auto got = contact::ballistic_motion(MotionState<S>{x, v}, a, t);
    const Rational way = oracle::exact(v) * oracle::exact(t);
    const Rational fall = oracle::exact(a) * oracle::exact(t) * oracle::exact(t) / 2;
    const Rational size = abs(oracle::exact(x)) + abs(way) + abs(fall);
    const Rational right = oracle::exact(x) + way + fall;
    REQUIRE(oracle::exact(oracle::error(double(got.position), right)) <= 4 * u<S>() * size);
  }
}

namespace {

/// The first t ≥ 0 at which gap + rate t + a t²/2 ≤ 0 and the gap shrinks, as a number with one
/// square root; nothing if there is none.
std::optional<Surd> closing(const Rational& gap, const Rational& rate, const Rational& a) {
  const bool shrinks = rate < 0 || (rate == 0 && a < 0);
  if (gap <= 0) {
    if (shrinks) return Surd{0, 0, 0};
    if (a >= 0) return std::nullopt;
  }
  const Rational square = rate * rate - 2 * a * gap;
  if (a == 0) return rate < 0 ? std::optional<Surd>(Surd{-gap / rate, 0, 0}) : std::nullopt;
  if (square < 0) return gap <= 0 ? std::optional<Surd>(Surd{-rate / a, 0, 0}) : std::nullopt;
  if (gap > 0 && a > 0 && rate >= 0) return std::nullopt;
  // For a > 0 the smaller of the two positive roots, for a < 0 the only positive one or the later:
  // (−rate − √square) / a in both cases.
  return Surd{-rate / a, -1 / a, square};
}

}  // namespace

TEMPLATE_TEST_CASE("whether and when a gap closes", "", float, double) {
  using S = TestType;
  Random random(1907);
  int never = 0;
  int grazing = 0;
  for (int i = 0; i < 12000; ++i) {
    S gap = S(std::abs(random.magnitude(-8, 8)));
    S rate = S(random.magnitude(-6, 6));
    S a = S(random.magnitude(-6, 6));
    const int kind = random.integer(0, 9);
    if (kind == 0) gap = S(0);
    if (kind == 1) gap = -gap;
    if (kind == 2) a = S(0);
    if (kind == 3) rate = S(0);
    if (kind >= 6) {  // a ceiling that is only just reached, or just missed
      a = std::abs(a);
      rate = -std::abs(rate);
      gap = rate * rate / (S(2) * a);
      for (int steps = random.integer(-2, 2); steps != 0; steps += steps > 0 ? -1 : 1) {
        gap = std::nextafter(gap, steps > 0 ? S(1e9) : S(0));
      }
    }
    if (kind == 9) {  // exactly
      const int p = random.integer(-3, 3);
      a = S(std::ldexp(1.0, p));
      rate = -S(random.integer(1, 64));
      gap = rate * rate / (S(2) * a);
    }
    const auto right = closing(oracle::exact(gap), oracle::exact(rate), oracle::exact(a));
    const auto got = contact::closing_time(gap, rate, a);
    INFO("gap " << gap << " rate " << rate << " a " << a);
    REQUIRE(got.has_value() == right.has_value());
    never += !right;
    if (!right) continue;
    grazing += right->d == 0 && right->b != 0;
    const double off = oracle::error(double(*got), *right);
    REQUIRE(oracle::exact(off) <= 16 * u<S>() * oracle::exact(*got));
  }
  CHECK(never > 1000);
  CHECK(grazing > 1000);
}

TEST_CASE("closing times scale by powers of two, except for the largest and smallest numbers") {
  Random random(1908);
  for (int i = 0; i < 2000; ++i) {
    const double gap = std::abs(random.magnitude(-2, 2));
    const double rate = random.magnitude(-2, 2);
    const double a = random.magnitude(-2, 2);
    const auto plain = contact::closing_time(gap, rate, a);
    const int metres = random.integer(-120, 120);
    const int seconds = random.integer(-60, 60);
    const auto scaled =
        contact::closing_time(std::ldexp(gap, metres), std::ldexp(rate, metres - seconds),
                              std::ldexp(a, metres - 2 * seconds));
    REQUIRE(plain.has_value() == scaled.has_value());
    if (plain) REQUIRE(*scaled == std::ldexp(*plain, seconds));
  }
  // The function is total: extreme finite numbers give a finite time or nothing.
  const double huge = std::numeric_limits<double>::max();
  const double tiny = std::numeric_limits<double>::denorm_min();
  for (const double gap : {0.0, tiny, 1.0, huge, -huge, -tiny}) {
    for (const double rate : {0.0, tiny, -tiny, 1.0, -1.0, huge, -huge}) {
      for (const double a : {0.0, tiny, -tiny, 1.0, -1.0, huge, -huge}) {
        const auto t = contact::closing_time(gap, rate, a);
        CHECK((!t || (std::isfinite(*t) && *t >= 0)));
      }
    }
  }
}
