/// @file
/// The exact sign of a determinant of differences of doubles, in integers of fixed size: what
/// decides where a floating-point filter is in doubt. It is much faster than `Exact`, but does not
/// take numbers that span too many bits.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <contact/error_free.hpp>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

namespace contact::difference_detail {

using Integer = std::int64_t;

inline int sign_of(double x) { return x > 0 ? 1 : (x < 0 ? -1 : 0); }

// [modulo]
/// A sum of products of integers that is known to be `rounded` up to an error of less than 2^61,
/// and to be `residue` modulo 2^64: its sign.
///
/// If |rounded| ≥ 2^61, the error cannot change the sign. Otherwise the exact sum is below 2^62 in
/// magnitude, and of all numbers with that residue only one is.
inline int sign_from_residue(double rounded, std::uint64_t residue) {
  if (std::abs(rounded) >= 0x1p61) return sign_of(rounded);
  const auto exact = static_cast<Integer>(residue);
  return exact > 0 ? 1 : (exact < 0 ? -1 : 0);
}
// [/modulo]

/// The bits of a digit.
inline constexpr int digit_bits = 28;

/// A whole number Σ digit[i]·2^(28 i). A digit may have either sign.
template <std::size_t n>
using Digits = std::array<Integer, n>;

/// Makes all digits but the last lie from 0 to 2^28 − 1, without changing the number. Its sign is
/// then that of the last digit, or if that is 0, of any other.
template <std::size_t n>
int carry_and_sign(Digits<n>& x) {
  Integer rest = 0;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    x[i + 1] += x[i] >> digit_bits;  // rounds down
    x[i] &= (Integer{1} << digit_bits) - 1;
    rest |= x[i];
  }
  return x[n - 1] < 0 ? -1 : ((x[n - 1] | rest) != 0 ? 1 : 0);
}

/// Adds times·x y to the digits of a sum. The loops are unrolled by the templates.
template <std::size_t n, std::size_t m, std::size_t k>
void add_product(Digits<k>& sum, const Digits<n>& x, const Digits<m>& y, Integer times) {
  static_assert(n + m - 1 <= k);
  const auto row = [&]<std::size_t... j>(std::size_t i, Integer factor, std::index_sequence<j...>) {
    ((sum[i + j] += factor * y[j]), ...);
  };
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    (row(i, times * x[i], std::make_index_sequence<m>{}), ...);
  }
  (std::make_index_sequence<n>{});
}

/// The exponent of a positive normal number as it is stored: the number is below 2 to this − 1022.
inline int stored_exponent(double x) {
  return static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52);
}
/// 2 to an exponent from −1022 to 1023.
inline double power_of_two(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52);
}

/// Converts numbers to n digits of a unit.
template <std::size_t n>
class Scaling {
 public:
  /// @param stored the stored exponent of the largest number, of magnitude from 2^-900 to 2^900
  explicit Scaling(int stored)
      : to_high_(power_of_two(1022 + high_bits - stored)),
        to_low_(power_of_two(low_bits)),
        to_unit_(power_of_two(1022 + high_bits + low_bits - stored)) {}

  /// The digits of value + error, where the error is at most half of the last bit of the largest
  /// number; sets `whole` to false if they are no multiple of the unit.
  ///
  /// First the 56 highest bits are cut off, then the rest of the value. No step rounds but the
  /// first, and that only what is below the smallest normal number, and so no multiple of the unit.
  Digits<n> digits(double value, double error, bool& whole) const {
    const double scaled = value * to_high_;
    const auto high = static_cast<Integer>(scaled);
    const double rest = (scaled - static_cast<double>(high)) * to_low_;
    const double scaled_error = error * to_unit_;
    const auto low = static_cast<Integer>(rest), of_error = static_cast<Integer>(scaled_error);
    whole = whole & (static_cast<double>(low) == rest) &
            (static_cast<double>(of_error) == scaled_error) & ((scaled == 0) == (value == 0)) &
            ((of_error == 0) == (error == 0));
    Digits<n> x;
    Integer carried = low + of_error;
    for (std::size_t i = 0; i + 2 < n; ++i) {
      x[i] = carried & ((Integer{1} << digit_bits) - 1);
      carried >>= digit_bits;
    }
    carried += high;
    x[n - 2] = carried & ((Integer{1} << digit_bits) - 1);
    x[n - 1] = carried >> digit_bits;
    return x;
  }

 private:
  static_assert(n == 3 || n == 4, "the lower digits and an error are below 2^60");
  static constexpr int high_bits = 2 * digit_bits;
  static constexpr int low_bits = digit_bits * (static_cast<int>(n) - 2);
  double to_high_, to_low_, to_unit_;
};

/// Some differences of doubles.
template <std::size_t count>
class Differences {
 public:
  /// Sets number i to x − y without error: the rounded difference and its rounding error.
  void set(std::size_t i, double x, double y) {
    const auto [value, error] = two_sum(x, -y);
    value_[i] = value;
    error_[i] = error;
    largest_ = std::max(largest_, std::abs(value));
    rounded_ = rounded_ || error != 0;
  }
  /// Whether a difference has a rounding error.
  bool rounded() const { return rounded_; }
  /// Whether all differences are 0.
  bool zero() const { return largest_ == 0; }
  /// Whether the numbers can be scaled: no step of `set` overflowed, and the powers of two below
  /// are normal.
  bool scalable() const { return largest_ < 0x1p900 && largest_ > 0x1p-900; }

  /// Converts all, times a common power of two, to integers below 2^bits in magnitude; false if
  /// they need more bits. They must be scalable.
  bool as_integers(int bits, std::array<Integer, count>& x) const {
    const double factor = scale(bits), unit = scale_back(bits);
    bool whole = true;
    for (std::size_t i = 0; i < count; ++i) {
      const auto of_value = static_cast<Integer>(value_[i] * factor);
      const auto of_error = static_cast<Integer>(error_[i] * factor);
      x[i] = of_value + of_error;
      whole = whole && static_cast<double>(of_value) * unit == value_[i] &&
              static_cast<double>(of_error) * unit == error_[i];
    }
    return whole;
  }

  /// Converts all, times a common power of two, to n digits; false if they need more. They must be
  /// scalable.
  template <std::size_t n>
  bool as_digits(std::array<Digits<n>, count>& x) const {
    const Scaling<n> scaling(stored_exponent());
    bool whole = true;
    for (std::size_t i = 0; i < count; ++i) {
      x[i] = scaling.digits(value_[i], error_[i], whole);
    }
    return whole;
  }

 private:
  std::array<double, count> value_{}, error_{};
  double largest_ = 0;
  bool rounded_ = false;

  int stored_exponent() const { return difference_detail::stored_exponent(largest_); }
  /// The power of two by which the largest number is from 2^(bits − 1) to 2^bits.
  double scale(int bits) const { return power_of_two(1022 + bits - stored_exponent()); }
  /// Its inverse.
  double scale_back(int bits) const { return power_of_two(stored_exponent() - 1022 - bits); }
};

/// p₀ q₁ − p₁ q₀, of numbers in n digits: at most 2n products of two digits in a sum, below 2^60.
template <std::size_t n>
Digits<2 * n> area(const Digits<n>& p0, const Digits<n>& p1, const Digits<n>& q0,
                   const Digits<n>& q1) {
  static_assert(n <= 4);
  Digits<2 * n> sum{};
  add_product(sum, p0, q1, 1);
  add_product(sum, p1, q0, -1);
  return sum;
}

/// The sign of p · (q × r) if all fit into n digits.
///
/// A digit of the sum is of at most 3n products of a digit of p, below 2^28, and one of q × r,
/// below 2^28, or for the last one, at most 2^29: below 2^61.
template <std::size_t n>
std::optional<int> sign_in_digits(const Differences<9>& numbers) {
  std::array<Digits<n>, 9> x;
  if (!numbers.as_digits<n>(x)) return std::nullopt;
  Digits<3 * n> volume{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    Digits<2 * n> minor = area<n>(x[3 + j], x[3 + k], x[6 + j], x[6 + k]);
    carry_and_sign(minor);
    add_product(volume, x[i], minor, 1);
  }
  return carry_and_sign(volume);
}
/// The sign of p × q if all fit into n digits.
template <std::size_t n>
std::optional<int> sign_in_digits(const Differences<4>& numbers) {
  std::array<Digits<n>, 4> x;
  if (!numbers.as_digits<n>(x)) return std::nullopt;
  Digits<2 * n> sum = area<n>(x[0], x[1], x[2], x[3]);
  return carry_and_sign(sum);
}

/// The sign of p × q, of the numbers p₀, p₁, q₀, q₁ in this order; nothing if they span more than
/// 112 bits or are at the ends of the range of double.
///
/// Of integers below 2^55 the rounded value is off by less than 4 roundings of two products: 2^60.
inline std::optional<int> determinant_sign(const Differences<4>& numbers) {
  if (numbers.zero()) return 0;
  if (!numbers.scalable()) return std::nullopt;
  std::array<Integer, 4> x;
  if (!numbers.as_integers(55, x)) return sign_in_digits<4>(numbers);
  const auto real = [&x](std::size_t i) { return static_cast<double>(x[i]); };
  const auto whole = [&x](std::size_t i) { return static_cast<std::uint64_t>(x[i]); };
  return sign_from_residue(real(0) * real(3) - real(1) * real(2),
                           whole(0) * whole(3) - whole(1) * whole(2));
}

/// The sign of p · (q × r), of nine numbers in this order; nothing if they span more than 112 bits
/// or are at the ends of the range of double.
///
/// Of integers below 2^36 the rounded value is off by less than 9u times six products: 2^61.
inline std::optional<int> determinant_sign(const Differences<9>& numbers) {
  if (numbers.zero()) return 0;
  if (!numbers.scalable()) return std::nullopt;
  std::array<Integer, 9> x;
  if (numbers.rounded() || !numbers.as_integers(36, x)) {
    const std::optional<int> sign = sign_in_digits<3>(numbers);
    return sign ? sign : sign_in_digits<4>(numbers);
  }
  double rounded = 0;
  std::uint64_t residue = 0;
  const auto real = [&x](std::size_t i) { return static_cast<double>(x[i]); };
  const auto whole = [&x](std::size_t i) { return static_cast<std::uint64_t>(x[i]); };
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    rounded += real(i) * (real(3 + j) * real(6 + k) - real(3 + k) * real(6 + j));
    residue += whole(i) * (whole(3 + j) * whole(6 + k) - whole(3 + k) * whole(6 + j));
  }
  return sign_from_residue(rounded, residue);
}

__extension__ typedef __int128 WideInteger;

/// Some coordinates as whole multiples of a common unit, if they are.
class Multiples {
 public:
  /// @param longest of all differences, rounded
  /// @param largest of all magnitudes
  /// @param bits of the longest difference in units, at most
  Multiples(double longest, double largest, int bits) {
    if (!(largest < 0x1p900 && longest > 0x1p-900)) return;
    const auto above = [](double x) { return stored_exponent(x) - 1022; };
    const int exponent = std::max(above(longest) - bits, above(largest) - 62);
    unit_ = power_of_two(exponent);
    per_unit_ = power_of_two(-exponent);
  }
  /// How many units x is, below 2^62; unless it is a whole number of them, all_whole() is false
  /// from then on.
  Integer operator()(double x) {
    const auto multiple = static_cast<Integer>(x * per_unit_);
    all_whole_ = all_whole_ & (static_cast<double>(multiple) * unit_ == x);
    return multiple;
  }
  /// Whether the numbers can be scaled.
  bool scalable() const { return unit_ != 0; }
  /// Whether each was a whole number of units.
  bool all_whole() const { return all_whole_; }

 private:
  double unit_ = 0, per_unit_ = 0;
  bool all_whole_ = true;
};

/// The sign of (d − a) · ((b − a) × (c − a)) if all coordinates are whole multiples of a unit below
/// 2^62 and differ by at most 2^41 of it: floats of similar size, points of a grid. Six products of
/// three such differences are below 2^126.
/// @param a,b,c,d finite, of three coordinates
template <class Point>
std::optional<int> whole_volume_sign(const Point& a, const Point& b, const Point& c,
                                     const Point& d) {
  double longest = 0, largest = 0;
  for (int k = 0; k < 3; ++k) {
    const double low = std::min(std::min(a[k], b[k]), std::min(c[k], d[k]));
    const double high = std::max(std::max(a[k], b[k]), std::max(c[k], d[k]));
    longest = std::max(longest, high - low);
    largest = std::max(largest, std::max(high, -low));
  }
  Multiples multiples(longest, largest, 41);
  if (!multiples.scalable()) return std::nullopt;
  std::array<Integer, 3> p, q, r;
  for (int k = 0; k < 3; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const Integer start = multiples(a[k]);
    p[i] = multiples(d[k]) - start;
    q[i] = multiples(b[k]) - start;
    r[i] = multiples(c[k]) - start;
  }
  if (!multiples.all_whole()) return std::nullopt;
  WideInteger volume = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    volume += p[i] * (WideInteger{q[j]} * r[k] - WideInteger{q[k]} * r[j]);
  }
  return volume > 0 ? 1 : (volume < 0 ? -1 : 0);
}

}  // namespace contact::difference_detail
