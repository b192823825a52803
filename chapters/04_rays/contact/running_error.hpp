/// @file
/// Running error analysis: a double together with a bound on its error, so that one formula serves
/// as a floating-point filter and, with another number type, as its exact fallback.
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include <contact/exact.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>

namespace contact {

// [running-error]
/// A computed number and a bound on its error: the exact one differs from value by at most bound.
///
/// Each operation adds its own rounding, at most u |result|, to what the errors of its operands
/// become: |x| e(y) + |y| e(x) + e(x) e(y) for a product, and so on. The factor 1 + 8u covers the
/// roundings of the bound itself, and 2^-1000 all underflow. A 0 that is known exactly stays exact:
/// times anything, also ∞ or NaN, it is 0. If anything overflows, the bound is infinite or NaN, and
/// no sign is certain; nor is that of a NaN. Numbers are not checked: an ∞ that is given as exact
/// has its sign.
struct RunningError {
  double value = 0;  ///< as computed
  double bound = 0;  ///< of its error; infinite or NaN after an overflow

  RunningError() = default;
  /// A number without error.
  RunningError(double exact) : value(exact) {}
  /// A computed number and a bound on its error, not negative.
  RunningError(double computed, double error) : value(computed), bound(error) {}

  /// Whether the exact number is known to be 0.
  bool is_zero() const { return value == 0 && bound == 0; }
  /// The sign of the exact number if it is certain, else 0.
  int certain_sign() const { return value > bound ? 1 : (value < -bound ? -1 : 0); }

  /// The unit roundoff.
  static constexpr double u = std::numeric_limits<double>::epsilon() / 2;
  /// More than all that underflow can take from one operation and its bound.
  static constexpr double floor = 0x1p-1000;
  /// A bound that covers the roundings with which it was computed.
  static double up(double error) { return error * (1 + 8 * u); }

  friend RunningError operator-(const RunningError& x) { return {-x.value, x.bound}; }
  friend RunningError operator+(const RunningError& x, const RunningError& y) {
    if (x.is_zero()) return y;
    if (y.is_zero()) return x;
    const double sum = x.value + y.value;
    return {sum, up(x.bound + y.bound + u * std::abs(sum))};
  }
  friend RunningError operator-(const RunningError& x, const RunningError& y) { return x + -y; }
  friend RunningError operator*(const RunningError& x, const RunningError& y) {
    if (x.is_zero() || y.is_zero()) return {};
    const double product = x.value * y.value;
    return {product, up(std::abs(x.value) * y.bound + std::abs(y.value) * x.bound +
                        x.bound * y.bound + u * std::abs(product)) +
                         floor};
  }
  /// The quotient; without a finite bound unless y is certain not to be 0.
  friend RunningError operator/(const RunningError& x, const RunningError& y) {
    const double quotient = x.value / y.value;
    const double least = std::abs(y.value) - y.bound;
    if (!(least > 0)) return {quotient, std::numeric_limits<double>::infinity()};
    if (x.is_zero()) return {};
    return {quotient, up((x.bound + std::abs(quotient) * y.bound) / (least * (1 - 4 * u)) +
                         u * std::abs(quotient)) +
                          floor};
  }
  /// The root of a number that is known not to be negative: |√X − √x| = |X − x|/(√X + √x). A value
  /// that is not positive has the root 0, with a bound for what it may be.
  friend RunningError sqrt(const RunningError& x) {
    if (x.is_zero()) return {};
    if (!(x.value > 0)) return {0, up(std::sqrt(std::abs(x.value) + x.bound)) + floor};
    const double root = std::sqrt(x.value);
    return {root, up(x.bound / root + u * root) + floor};
  }
};
// [/running-error]

namespace detail {

/// The sign of a number; sets `sure` to false if it is not certain.
inline int sign_of(const Exact& x, bool&) { return x.sign(); }
inline int sign_of(const RunningError& x, bool& sure) {
  const int sign = x.certain_sign();
  if (sign == 0 && !x.is_zero()) sure = false;
  return sign;
}

/// Three numbers of any type with + − ×; Eigen's vectors would ask for an order.
template <class T>
using Triple = std::array<T, 3>;

template <class T>
T dot(const Triple<T>& x, const Triple<T>& y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}
template <class T>
Triple<T> cross(const Triple<T>& x, const Triple<T>& y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}
template <class T>
Triple<T> minus(const Triple<T>& x, const Triple<T>& y) {
  return {x[0] - y[0], x[1] - y[1], x[2] - y[2]};
}
template <class T>
Triple<T> triple(const Vector3<double>& x) {
  return {T(x.x()), T(x.y()), T(x.z())};
}

}  // namespace detail

}  // namespace contact
