#include "support/oracle.hpp"

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <cstring>
#include <limits>

using namespace oracle;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Bit patterns without a pattern, of every exponent.
double any_double(std::uint64_t& state) {
  for (;;) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    const std::uint64_t bits = state ^ (state >> 29);
    double x = 0;
    std::memcpy(&x, &bits, sizeof x);
    if (std::isfinite(x)) return x;
  }
}

}  // namespace

TEST_CASE("a double goes to a rational and back unchanged, subnormal and largest included") {
  std::uint64_t state = 1;
  for (int i = 0; i < 20000; ++i) {
    const double x = any_double(state);
    REQUIRE(nearest(exact(x)) == x);
  }
  for (const double x : {0.0, 5e-324, -5e-324, 2.2250738585072014e-308, 1.7976931348623157e308}) {
    CHECK(nearest(exact(x)) == x);
  }
  CHECK_THROWS_AS(exact(not_a_number), std::invalid_argument);
  CHECK_THROWS_AS(exact(infinity), std::invalid_argument);
}

TEST_CASE("a rational rounds to nearest, ties to even, and as the hardware rounds a quotient") {
  std::uint64_t state = 2;
  for (int i = 0; i < 20000; ++i) {
    const double x = any_double(state);
    const double y = any_double(state);
    if (y == 0) continue;
    REQUIRE(nearest(exact(x) / exact(y)) ==
            x / y);  // IEEE division rounds to nearest, ties to even
  }
  const Rational half_ulp = exact(std::ldexp(1.0, -53));
  CHECK(nearest(1 + half_ulp) == 1.0);
  CHECK(nearest(1 + 3 * half_ulp) == 1.0 + std::ldexp(1.0, -51));
  CHECK(nearest(exact(5e-324) / 2) == 0.0);
  CHECK(nearest(exact(5e-324) * 3 / 2) == 1e-323);
  CHECK(nearest(exact(1.7976931348623157e308) * 2) == infinity);
  CHECK(nearest(-exact(1.7976931348623157e308) * 2) == -infinity);
  for (int i = 0; i < 5000; ++i) {
    const float x = static_cast<float>(std::fmod(any_double(state), 1e6));
    const float y = static_cast<float>(std::fmod(any_double(state), 1e6));
    if (y == 0) continue;
    REQUIRE(nearest_float(exact(x) / exact(y)) == x / y);
  }
}

TEST_CASE("an error is rounded up, and is infinite for what is no number") {
  CHECK(error(0.5, Rational(1, 2)) == 0.0);
  CHECK(error(0.25, Rational(1, 2)) == 0.25);
  CHECK(exact(error(1.0 / 3, Rational(1, 3))) >= abs(exact(1.0 / 3) - Rational(1, 3)));
  CHECK(error(not_a_number, Rational(0)) == infinity);
  CHECK_FALSE(error(not_a_number, Rational(0)) <= 1e300);
}

TEST_CASE("rationals are read as p/q and as decimals, and nothing else is") {
  CHECK(parse_rational("-3/6") == Rational(-1, 2));
  CHECK(parse_rational("0.1") == Rational(1, 10));
  CHECK(parse_rational("-0.125") == Rational(-1, 8));
  CHECK(parse_rational("010") == 10);
  CHECK(text(Rational(-4, 6)) == "-2/3");
  CHECK(text(Rational(7)) == "7");
  for (const char* bad : {"", "-", "1/0", "1/-2", "x", "1e5", "1.", "0x1", "1/2/3", "1.-5"}) {
    CHECK_THROWS_AS(parse_rational(bad), std::invalid_argument);
  }
}

TEST_CASE("the sign of a + b root d is decided where doubles see nothing") {
  CHECK(sign(Surd{1, -1, 1}) == 0);
  CHECK(sign(Surd{3, -2, 2}) == 1);  // 3 > 2.83
  CHECK(sign(Surd{-3, 2, 2}) == -1);
  CHECK(sign(Surd{0, 1, 0}) == 0);
  // Convergents p/q of √2 alternate round it, closer than any double can tell from some point on.
  Integer p = 1;
  Integer q = 1;
  int expected = -1;  // 1 - √2 < 0
  for (int i = 0; i < 200; ++i) {
    CHECK(sign(Surd{Rational(p), Rational(Integer(-q)), 2}) == expected);
    const Integer next = p + 2 * q;
    q = p + q;
    p = next;
    expected = -expected;
  }
}

TEST_CASE("two numbers with different roots are ordered") {
  CHECK(compare(Surd{0, 1, 2}, Surd{0, 1, 3}) == -1);
  CHECK(compare(Surd{0, 1, 8}, Surd{0, 2, 2}) == 0);
  CHECK(compare(Surd{1, 1, 2}, Surd{0, 1, 6}) == -1);  // 2.41421 < 2.44949
  CHECK(compare(Surd{0, -1, 2}, Surd{0, -1, 3}) == 1);
  for (int a = -4; a <= 4; ++a) {
    for (int b = -4; b <= 4; ++b) {
      for (int c = -4; c <= 4; ++c) {
        for (int d = -4; d <= 4; ++d) {
          const double x = a + b * std::sqrt(2.0);
          const double y = c + d * std::sqrt(5.0);
          const int seen = std::abs(x - y) < 1e-9 ? 0 : (x > y ? 1 : -1);
          REQUIRE(compare(Surd{a, b, 2}, Surd{c, d, 5}) == seen);
        }
      }
    }
  }
}

TEST_CASE("a square root rounds as the hardware rounds it") {
  std::uint64_t state = 3;
  for (int i = 0; i < 3000; ++i) {
    const double x = std::abs(any_double(state));
    REQUIRE(nearest(Surd{0, 1, exact(x)}) == std::sqrt(x));
  }
  CHECK(error(std::sqrt(2.0), Surd{0, 1, 2}) < std::ldexp(1.0, -52));
  CHECK(error(std::sqrt(2.0), Surd{0, 1, 2}) > 0);
  CHECK(error(1.5, Surd{0, 1, Rational(9, 4)}) == 0);
}

TEST_CASE("a quadratic has its roots in order, and they are roots") {
  const Quadratic two{1, -3, 1};
  const auto roots = two.roots();
  REQUIRE(roots.size() == 2);
  CHECK(compare(roots[0], roots[1]) == -1);
  for (const Surd& x : roots) {  // a x² + b x + c = 0 in the field: both the rational part and the
                                 // part with √d vanish
    CHECK(two.a * (x.a * x.a + x.b * x.b * x.d) + two.b * x.a + two.c == 0);
    CHECK(two.a * 2 * x.a * x.b + two.b * x.b == 0);
  }
  const auto downward = Quadratic{-1, 3, -1}.roots();
  REQUIRE(downward.size() == 2);
  CHECK(compare(downward[0], roots[0]) == 0);
  CHECK(Quadratic{1, 2, 1}.roots().size() == 1);
  CHECK(Quadratic{1, 0, 1}.roots().empty());
  CHECK(Quadratic{0, 2, -3}.roots()[0].a == Rational(3, 2));
  CHECK(Quadratic{0, 0, 1}.roots().empty());
  CHECK_THROWS_AS((Quadratic{0, 0, 0}.roots()), std::invalid_argument);
}

TEST_CASE("intervals contain what they stand for, and decide by growing") {
  const auto sine_identity =
      [](unsigned bits) {  // sin² + cos² - 1 is 0, which no interval can show
        const Interval x(Rational(1, 3), bits);
        return sin(x) * sin(x) + cos(x) * cos(x) - Interval(1, bits);
      };
  const DecidedSign undecided = decide_sign(sine_identity, 1024);
  CHECK_FALSE(undecided.sign.has_value());
  CHECK(undecided.bits == 1024);

  // π against its 40-digit convergent-like decimal: 64 bits cannot tell, more can.
  const Rational digits = parse_rational("3.14159265358979323846264338327950288419716939937510");
  const DecidedSign decided =
      decide_sign([&](unsigned bits) { return Interval::pi(bits) - Interval(digits, bits); });
  REQUIRE(decided.sign.has_value());
  CHECK(*decided.sign == 1);
  CHECK(decided.bits > 64);

  CHECK(nearest_value([](unsigned bits) { return Interval::pi(bits); }) == 3.141592653589793);
  CHECK(nearest_value([](unsigned bits) { return exp(Interval(1, bits)); }) == 2.718281828459045);
  CHECK(nearest_value([](unsigned bits) { return log(Interval(2, bits)); }) == 0.6931471805599453);
  CHECK(nearest_value([](unsigned bits) { return tan(atan(Interval(Rational(1, 10), bits))); }) ==
        0.1);
  CHECK(nearest_value([](unsigned bits) {
          return cos(acos(asin(sin(Interval(Rational(1, 10), bits)))));
        }) == 0.1);
  CHECK(Interval(Rational(1, 3), 64).low() < Rational(1, 3));
  CHECK(Interval(Rational(1, 3), 64).high() > Rational(1, 3));
  CHECK(decide_sign([](unsigned bits) { return -sqrt(Interval(2, bits)); }).sign == -1);
  CHECK(decide_sign([](unsigned bits) { return Interval(bits) / Interval(2, bits); }).sign == 0);
}

TEST_CASE("an integral is enclosed, more tightly with more pieces") {
  const auto square = [](const Interval& x) { return x * x; };
  const Enclosure coarse = enclose_integral(square, 0, 1, 10);
  const Enclosure fine = enclose_integral(square, 0, 1, 1000);
  CHECK(coarse.contains(Rational(1, 3)));
  CHECK(fine.contains(Rational(1, 3)));
  CHECK(fine.width() * 50 < coarse.width());
  CHECK(fine.error(1.0 / 3) < 0.002);
  CHECK(fine.error(not_a_number) == infinity);
}

TEST_CASE("a thrown body is where the closed form says") {
  const Vector where =
      ballistic(Vector(0, 10, 0), Vector(3, 0, 0), Vector(0, Rational(-1, 2), 0), 2);
  CHECK(where == Vector(6, 9, 0));
}
