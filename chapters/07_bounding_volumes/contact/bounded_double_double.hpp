/// @file
/// Numbers of about 106 bits together with a bound on their error: the second floating-point
/// filter, where one of doubles is in doubt.
#pragma once

#include <cmath>
#include <contact/error_free.hpp>
#include <contact/running_error.hpp>
#include <limits>

namespace contact {

/// An unevaluated sum of two doubles and a bound on its error: the exact number differs from high +
/// low by at most bound.
///
/// It has the same operations as `RunningError`, and carries twice as many digits. Nothing is
/// estimated: two_sum() and two_product() are exact, so whatever an operation leaves out is itself
/// a double that is known, and its magnitude goes into the bound. If nothing is left out, the bound
/// stays 0: numbers of few digits, such as whole ones, stay exact, and a 0 of theirs is certain.
///
/// The factor 1 + 16u covers the roundings of the bound itself, and 2^-1000 all underflow. After an
/// overflow the bound is infinite or NaN, and no sign is certain.
///
/// An infinite number that is given as exact has a certain sign, NaN has none; no sum, difference,
/// product or quotient of either has one. Only a certain 0 stays one: as a factor of anything, and
/// divided by what has a certain sign.
struct BoundedDoubleDouble {
  double high = 0;   ///< the sum, rounded
  double low = 0;    ///< its rounding error
  double bound = 0;  ///< of the error of both together; infinite or NaN after an overflow

  BoundedDoubleDouble() = default;
  /// A number without error.
  BoundedDoubleDouble(double exact) : high(exact) {}
  /// A sum of two doubles, the second of which is at most half an ulp of the first.
  BoundedDoubleDouble(double sum, double rest, double error) : high(sum), low(rest), bound(error) {}

  /// Whether the exact number is known to be 0.
  bool is_zero() const { return high == 0 && low == 0 && bound == 0; }
  /// The sign of the exact number if it is certain, else 0. |high + low| ≥ (1 − u) |high|.
  int certain_sign() const {
    const double reach = bound * (1 + 4 * RunningError::u);
    return high > reach ? 1 : (high < -reach ? -1 : 0);
  }

  /// A bound that covers the roundings with which it was computed.
  static double up(double error) { return error * (1 + 16 * RunningError::u); }

  friend BoundedDoubleDouble operator-(const BoundedDoubleDouble& x) {
    return {-x.high, -x.low, x.bound};
  }
  // [double-double-sum]
  friend BoundedDoubleDouble operator+(const BoundedDoubleDouble& x, const BoundedDoubleDouble& y) {
    const auto highs = two_sum(x.high, y.high), lows = two_sum(x.low, y.low);
    const auto middle = two_sum(highs.error, lows.value);
    const auto upper = two_sum(highs.value, middle.value);
    const auto lower = two_sum(upper.error, lows.error);
    const auto sum = two_sum(upper.value, lower.value);
    const double left_out = std::abs(middle.error) + std::abs(lower.error);
    return {sum.value, sum.error, up(x.bound + y.bound + left_out)};
  }
  // [/double-double-sum]
  friend BoundedDoubleDouble operator-(const BoundedDoubleDouble& x, const BoundedDoubleDouble& y) {
    return x + -y;
  }
  friend BoundedDoubleDouble operator*(const BoundedDoubleDouble& x, const BoundedDoubleDouble& y) {
    if (x.is_zero() || y.is_zero()) return {};
    const auto highs = two_product(x.high, y.high);
    const bool whole = x.low == 0 && y.low == 0 && x.bound == 0 && y.bound == 0;
    if (whole && std::abs(highs.value) > 0x1p-900 && std::isfinite(highs.error)) {
      return {highs.value, highs.error, 0};
    }
    const auto left = two_product(x.high, y.low), right = two_product(x.low, y.high);
    const auto cross = two_sum(left.value, right.value);
    const auto lows = two_sum(highs.error, cross.value);
    const auto product = two_sum(highs.value, lows.value);
    const double left_out = std::abs(cross.error) + std::abs(lows.error) + std::abs(left.error) +
                            std::abs(right.error) + std::abs(x.low * y.low);
    const double carried =
        std::abs(x.high) * y.bound + std::abs(y.high) * x.bound + x.bound * y.bound;
    // Whether a product may have lost something to underflow.
    const auto lost = [](double a, double b) {
      return a != 0 && b != 0 && !(std::abs(a * b) > 0x1p-900);
    };
    const bool underflow = lost(x.high, y.high) || lost(x.high, y.low) || lost(x.low, y.high) ||
                           lost(x.low, y.low) || x.bound != 0 || y.bound != 0;
    return {product.value, product.error,
            up(left_out + carried) + (underflow ? RunningError::floor : 0)};
  }
  /// The quotient, from two steps of long division; without a finite bound unless y is certain not
  /// to be 0. What is left to divide after them, divided by the least |y|, bounds the error; if
  /// nothing is left, there is none.
  friend BoundedDoubleDouble operator/(const BoundedDoubleDouble& x, const BoundedDoubleDouble& y) {
    if (x.is_zero() && y.certain_sign() != 0) return {};
    const double first = x.high / y.high;
    const BoundedDoubleDouble rest = x - y * BoundedDoubleDouble(first);
    const double second = rest.high / y.high;
    const BoundedDoubleDouble last = rest - y * BoundedDoubleDouble(second);
    const double least = std::abs(y.high) * (1 - 4 * RunningError::u) - y.bound;
    const auto quotient = two_sum(first, second);
    if (!(least > 0)) return {first, 0, std::numeric_limits<double>::infinity()};
    if (last.is_zero()) return {quotient.value, quotient.error, 0};
    return {quotient.value, quotient.error,
            up(up(std::abs(last.high) + last.bound) / (least * (1 - 4 * RunningError::u))) +
                RunningError::floor};
  }
};

namespace detail {

/// The sign of a number; sets `sure` to false if it is not certain.
inline int sign_of(const BoundedDoubleDouble& x, bool& sure) {
  const int sign = x.certain_sign();
  if (sign == 0 && !x.is_zero()) sure = false;
  return sign;
}

}  // namespace detail

}  // namespace contact
