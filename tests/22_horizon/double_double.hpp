/// @file
/// Numbers of about 32 digits as sums of two doubles, for tests that run in the page too, where
/// MPFR is not. Checked against MPFR in twins_test.cpp.
///
/// Source: Joldes, Muller and Popescu (2017): AccurateDWPlusDW, DWTimesDW3, DWDivDW2.
#pragma once

#include <cmath>

#include <contact/error_free.hpp>

namespace twins {

/// The number high + low, where high is the sum rounded to double.
struct DoubleDouble {
  double high = 0;
  double low = 0;
  DoubleDouble() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): doubles are among these numbers
  DoubleDouble(double value) : high(value) {}
  DoubleDouble(double h, double l) : high(h), low(l) {}
  explicit operator double() const { return high; }
};

/// The sum of two doubles of which the second is the smaller one.
inline DoubleDouble fast_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

inline DoubleDouble operator-(const DoubleDouble& x) { return {-x.high, -x.low}; }

inline DoubleDouble operator+(const DoubleDouble& x, const DoubleDouble& y) {
  const auto s = contact::two_sum(x.high, y.high);
  const auto t = contact::two_sum(x.low, y.low);
  const DoubleDouble v = fast_sum(s.value, s.error + t.value);
  return fast_sum(v.high, t.error + v.low);
}

inline DoubleDouble operator-(const DoubleDouble& x, const DoubleDouble& y) { return x + -y; }

inline DoubleDouble operator*(const DoubleDouble& x, const DoubleDouble& y) {
  const auto c = contact::two_product(x.high, y.high);
  const double lows = std::fma(x.low, y.high, std::fma(x.high, y.low, x.low * y.low));
  return fast_sum(c.value, c.error + lows);
}

inline DoubleDouble operator/(const DoubleDouble& x, const DoubleDouble& y) {
  const double quotient = x.high / y.high;
  const DoubleDouble rest = x - y * DoubleDouble(quotient);
  return fast_sum(quotient, rest.high / y.high);
}

/// For x of at least 0. One step of Newton from the root in double.
inline DoubleDouble sqrt(const DoubleDouble& x) {
  if (!(x.high > 0)) return 0.0;
  const double root = std::sqrt(x.high);
  const DoubleDouble rest = x - DoubleDouble(root) * DoubleDouble(root);
  return fast_sum(root, rest.high / (2 * root));
}

inline bool operator<(const DoubleDouble& x, const DoubleDouble& y) {
  return x.high < y.high || (x.high == y.high && x.low < y.low);
}
inline bool operator>(const DoubleDouble& x, const DoubleDouble& y) { return y < x; }

}  // namespace twins
