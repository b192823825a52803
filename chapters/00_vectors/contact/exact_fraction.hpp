/// @file
/// Exact fractions: quotients of exact numbers.
#pragma once

#include <cassert>
#include <compare>

#include <contact/exact.hpp>

namespace contact {

// [exact-fraction]
/// A quotient of two exact numbers, for exact formulas with divisions.
///
/// Fractions are not reduced: numerator and denominator grow with every operation. That suffices
/// for short formulas, such as a squared distance, but not for long computations. Division by 0 is
/// an error of the program, and asserts.
class ExactFraction {
 public:
  /// Zero.
  ExactFraction() : below_(1.0) {}
  /// An integer.
  ExactFraction(int value) : ExactFraction(static_cast<double>(value)) {}
  /// The value of a finite double, unchanged.
  ExactFraction(double value) : above_(value), below_(1.0) {}
  /// The value of an exact number, unchanged.
  explicit ExactFraction(const Exact& value) : above_(value), below_(1.0) {}

  /// -1, 0 or +1.
  int sign() const { return above_.sign(); }
  /// The closest double.
  double nearest() const { return quotient<double>(above_, below_); }

  friend ExactFraction operator-(const ExactFraction& x) { return {-x.above_, x.below_}; }
  friend ExactFraction operator+(const ExactFraction& x, const ExactFraction& y) {
    if (x.below_ == y.below_) return {x.above_ + y.above_, x.below_};
    return {x.above_ * y.below_ + y.above_ * x.below_, x.below_ * y.below_};
  }
  friend ExactFraction operator-(const ExactFraction& x, const ExactFraction& y) { return x + -y; }
  friend ExactFraction operator*(const ExactFraction& x, const ExactFraction& y) {
    return {x.above_ * y.above_, x.below_ * y.below_};
  }
  friend ExactFraction operator/(const ExactFraction& x, const ExactFraction& y) {
    assert(y.sign() != 0);
    if (y.sign() < 0) return {-(x.above_ * y.below_), -(x.below_ * y.above_)};
    return {x.above_ * y.below_, x.below_ * y.above_};
  }
  ExactFraction& operator+=(const ExactFraction& y) { return *this = *this + y; }
  ExactFraction& operator-=(const ExactFraction& y) { return *this = *this - y; }
  ExactFraction& operator*=(const ExactFraction& y) { return *this = *this * y; }
  ExactFraction& operator/=(const ExactFraction& y) { return *this = *this / y; }

  friend bool operator==(const ExactFraction& x, const ExactFraction& y) { return (x <=> y) == 0; }
  friend std::strong_ordering operator<=>(const ExactFraction& x, const ExactFraction& y) {
    if (x.sign() != y.sign()) return x.sign() <=> y.sign();
    return x.above_ * y.below_ <=> y.above_ * x.below_;
  }

 private:
  ExactFraction(const Exact& above, const Exact& below) : above_(above), below_(below) {}

  Exact above_;
  Exact below_;  // greater than 0
};
// [/exact-fraction]

}  // namespace contact

namespace Eigen {
/// Lets Eigen's vectors hold `contact::ExactFraction`.
template <>
struct NumTraits<contact::ExactFraction>
    : contact::detail::EigenTraits<contact::ExactFraction, 8, 200, 120> {};
}  // namespace Eigen
