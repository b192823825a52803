/// @file
/// A number as the unevaluated sum of two doubles: about 106 bits, a few hundred times faster than
/// exact arithmetic.
#pragma once

#include <cmath>
#include <compare>

#include <contact/error_free.hpp>

namespace contact {

/// The sum high + low, with |low| at most half an ulp of high.
///
/// The relative error of a sum or a difference is at most 3 u², of a product 5 u², of a quotient
/// 15 u², with u = 2^-53, if nothing overflows and no product or quotient is below about 2^-900.
/// @see Joldes, Muller and Popescu, *Tight and rigorous error bounds for basic building blocks of
/// double-word arithmetic*, ACM Transactions on Mathematical Software 44 (2017)
class DoubleDouble {
 public:
  DoubleDouble() = default;
  /// The value of a double, unchanged.
  DoubleDouble(double value) : high_(value) {}

  double high() const { return high_; }  ///< the double nearest to the sum
  double low() const { return low_; }    ///< the rest

  // [arithmetic]
  friend DoubleDouble operator-(const DoubleDouble& x) { return {-x.high_, -x.low_}; }
  friend DoubleDouble operator+(const DoubleDouble& x, const DoubleDouble& y) {
    const DoubleDouble high = two_sum(x.high_, y.high_);
    const DoubleDouble low = two_sum(x.low_, y.low_);
    const DoubleDouble both = quick_two_sum(high.high_, high.low_ + low.high_);
    return quick_two_sum(both.high_, low.low_ + both.low_);
  }
  friend DoubleDouble operator-(const DoubleDouble& x, const DoubleDouble& y) { return x + (-y); }
  friend DoubleDouble operator*(const DoubleDouble& x, const DoubleDouble& y) {
    const double product = x.high_ * y.high_;
    const double cut = std::fma(x.high_, y.high_, -product);
    return quick_two_sum(product, cut + (x.high_ * y.low_ + x.low_ * y.high_));
  }
  friend DoubleDouble operator/(const DoubleDouble& x, const DoubleDouble& y) {
    const double guess = x.high_ / y.high_;
    const DoubleDouble rest = x - y * DoubleDouble(guess);
    return quick_two_sum(guess, rest.high_ / y.high_);
  }
  // [/arithmetic]

  /// √x for x > 0, with an error of at most 4 u² of itself.
  friend DoubleDouble sqrt(const DoubleDouble& x) {
    const double guess = std::sqrt(x.high_);
    const double rest = std::fma(-guess, guess, x.high_) + x.low_;
    return quick_two_sum(guess, rest / (2 * guess));
  }

  friend bool operator==(const DoubleDouble& x, const DoubleDouble& y) = default;
  friend std::partial_ordering operator<=>(const DoubleDouble& x, const DoubleDouble& y) {
    const auto order = x.high_ <=> y.high_;
    return order != 0 ? order : x.low_ <=> y.low_;
  }

 private:
  double high_ = 0;
  double low_ = 0;

  DoubleDouble(double high, double low) : high_(high), low_(low) {}

  /// x + y without error.
  static DoubleDouble two_sum(double x, double y) {
    const WithError<double> sum = contact::two_sum(x, y);
    return {sum.value, sum.error};
  }
  /// The same for |x| ≥ |y|.
  static DoubleDouble quick_two_sum(double x, double y) {
    const double sum = x + y;
    return {sum, y - (sum - x)};
  }
};

}  // namespace contact
