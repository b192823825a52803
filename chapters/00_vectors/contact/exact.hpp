/// @file
/// Exact arithmetic, for predicates that must be right for every finite input.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace contact {

/// A number whose sums, differences and products are exact.
///
/// Every finite double is a whole number times a power of two (a dyadic number), and sums,
/// differences and products of such numbers are dyadic again. So a predicate that is the sign of a
/// polynomial of the input, as most geometric predicates are, can be evaluated without error. There
/// is no division: a third is not dyadic. Use `quotient`, which rounds once, at the end.
///
/// The value is ± Σ limbs[i]·2^(32·(i + scale)).
///
/// Limits: memory only. A product has as many limbs as its factors together, so the time grows with
/// the degree of the polynomial and with the spread of the exponents.
class Exact {
 public:
  /// Zero.
  Exact() = default;

  /// The value of a finite double. Implicit, because it is exact; -0.0 becomes 0. A value that is
  /// not finite is a programming error, and asserts.
  Exact(double value);

  /// -1, 0 or +1.
  int sign() const { return sign_; }

  friend Exact operator-(Exact x) {
    x.sign_ = -x.sign_;
    return x;
  }
  friend Exact operator+(const Exact& x, const Exact& y) { return sum(x, y, y.sign_); }
  friend Exact operator-(const Exact& x, const Exact& y) { return sum(x, y, -y.sign_); }
  friend Exact operator*(const Exact& x, const Exact& y);
  Exact& operator+=(const Exact& y) { return *this = *this + y; }
  Exact& operator-=(const Exact& y) { return *this = *this - y; }
  Exact& operator*=(const Exact& y) { return *this = *this * y; }

  friend bool operator==(const Exact& x, const Exact& y) { return (x <=> y) == 0; }
  friend std::strong_ordering operator<=>(const Exact& x, const Exact& y) {
    if (x.sign_ != y.sign_) return x.sign_ <=> y.sign_;
    return x.sign_ < 0 ? compare_magnitudes(y, x) : compare_magnitudes(x, y);
  }
  /// The magnitude of x.
  friend Exact abs(Exact x) {
    if (x.sign_ < 0) x.sign_ = 1;
    return x;
  }

  /// The floating-point number nearest to x (ties to even); ±infinity beyond the largest one,
  /// subnormal near zero.
  template <class Float>
  friend Float rounded(const Exact& x) {
    return quotient<Float>(x, Exact(1.0));
  }

  /// The floating-point number nearest to numerator/denominator: rounded once, so the error is at
  /// most half an ulp. The denominator must not be zero. A quotient that is too large gives
  /// ±infinity, one that is too small ±0.
  template <class Float>
  friend Float quotient(const Exact& numerator, const Exact& denominator) {
    assert(denominator.sign_ != 0);
    if (numerator.sign_ == 0) return Float(0);
    const Leading q = leading_bits(numerator, denominator);
    const Float magnitude = round_to_even<Float>(q.bits, q.exponent);
    return numerator.sign_ == denominator.sign_ ? magnitude : -magnitude;
  }

 private:
  using Limbs = std::vector<std::uint32_t>;

  /// The first 64 bits of a value: bits·2^exponent, with the last bit set if anything below it was
  /// cut off.
  struct Leading {
    std::uint64_t bits;
    std::int64_t exponent;
  };

  int sign_ = 0;
  std::int64_t scale_ = 0;
  Limbs limbs_;  // least significant first; neither end is zero

  std::int64_t top() const { return scale_ + static_cast<std::int64_t>(limbs_.size()); }
  std::uint32_t limb_at(std::int64_t position) const {
    if (position < scale_ || position >= top()) return 0;
    return limbs_[static_cast<std::size_t>(position - scale_)];
  }

  void strip() {
    while (!limbs_.empty() && limbs_.back() == 0) limbs_.pop_back();
    const auto first = std::find_if(limbs_.begin(), limbs_.end(), [](auto limb) { return limb; });
    scale_ += first - limbs_.begin();
    limbs_.erase(limbs_.begin(), first);
    if (limbs_.empty()) *this = Exact();
  }

  static std::strong_ordering compare_magnitudes(const Exact& x, const Exact& y) {
    if (x.limbs_.empty() || y.limbs_.empty()) return x.limbs_.size() <=> y.limbs_.size();
    if (x.top() != y.top()) return x.top() <=> y.top();
    for (std::int64_t i = x.top() - 1; i >= std::min(x.scale_, y.scale_); --i) {
      if (x.limb_at(i) != y.limb_at(i)) return x.limb_at(i) <=> y.limb_at(i);
    }
    return std::strong_ordering::equal;
  }

  static Exact sum(const Exact& x, const Exact& y, int sign_of_y);
  static Exact add_magnitudes(const Exact& x, const Exact& y);
  static Exact subtract_magnitudes(const Exact& larger, const Exact& smaller);
  static Leading leading_bits(const Exact& numerator, const Exact& denominator);
  template <class Float>
  static Float round_to_even(std::uint64_t bits, std::int64_t exponent);
};

inline Exact::Exact(double value) {
  assert(std::isfinite(value));
  if (value == 0) return;
  sign_ = value < 0 ? -1 : 1;
  int exponent = 0;
  const double fraction = std::frexp(std::abs(value), &exponent);  // in [1/2, 1)
  const auto mantissa = static_cast<std::uint64_t>(std::ldexp(fraction, 53));
  exponent -= 53;
  // value = mantissa·2^exponent; the limbs take the remainder of the exponent modulo 32.
  scale_ = exponent >= 0 ? exponent / 32 : -((31 - exponent) / 32);
  const int shift = exponent - 32 * static_cast<int>(scale_);
  const std::uint64_t low = (mantissa & 0xffffffffu) << shift;
  const std::uint64_t high = ((mantissa >> 32) << shift) + (low >> 32);
  limbs_ = {static_cast<std::uint32_t>(low), static_cast<std::uint32_t>(high),
            static_cast<std::uint32_t>(high >> 32)};
  strip();
}

inline Exact Exact::sum(const Exact& x, const Exact& y, int sign_of_y) {
  if (sign_of_y == 0) return x;
  if (x.sign_ == 0) {
    Exact result = y;
    result.sign_ = sign_of_y;
    return result;
  }
  Exact result;
  if (x.sign_ == sign_of_y) {
    result = add_magnitudes(x, y);
    result.sign_ = x.sign_;
    return result;
  }
  const auto order = compare_magnitudes(x, y);
  if (order == 0) return result;
  result = order > 0 ? subtract_magnitudes(x, y) : subtract_magnitudes(y, x);
  if (result.sign_ != 0) result.sign_ = order > 0 ? x.sign_ : sign_of_y;
  return result;
}

inline Exact Exact::add_magnitudes(const Exact& x, const Exact& y) {
  Exact result;
  result.sign_ = 1;
  result.scale_ = std::min(x.scale_, y.scale_);
  const std::int64_t end = std::max(x.top(), y.top());
  result.limbs_.reserve(static_cast<std::size_t>(end - result.scale_ + 1));
  std::uint64_t carry = 0;
  for (std::int64_t i = result.scale_; i < end; ++i) {
    carry += std::uint64_t{x.limb_at(i)} + y.limb_at(i);
    result.limbs_.push_back(static_cast<std::uint32_t>(carry));
    carry >>= 32;
  }
  result.limbs_.push_back(static_cast<std::uint32_t>(carry));
  result.strip();
  return result;
}

inline Exact Exact::subtract_magnitudes(const Exact& larger, const Exact& smaller) {
  Exact result;
  result.sign_ = 1;
  result.scale_ = std::min(larger.scale_, smaller.scale_);
  result.limbs_.reserve(static_cast<std::size_t>(larger.top() - result.scale_));
  std::uint64_t borrow = 0;
  for (std::int64_t i = result.scale_; i < larger.top(); ++i) {
    const std::uint64_t difference = std::uint64_t{larger.limb_at(i)} - smaller.limb_at(i) - borrow;
    result.limbs_.push_back(static_cast<std::uint32_t>(difference));
    borrow = difference >> 63;
  }
  result.strip();
  return result;
}

inline Exact operator*(const Exact& x, const Exact& y) {
  Exact result;
  if (x.sign_ == 0 || y.sign_ == 0) return result;
  result.sign_ = x.sign_ * y.sign_;
  result.scale_ = x.scale_ + y.scale_;
  result.limbs_.assign(x.limbs_.size() + y.limbs_.size(), 0);
  for (std::size_t i = 0; i < x.limbs_.size(); ++i) {
    std::uint64_t carry = 0;
    for (std::size_t j = 0; j < y.limbs_.size(); ++j) {
      carry += std::uint64_t{x.limbs_[i]} * y.limbs_[j] + result.limbs_[i + j];
      result.limbs_[i + j] = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
    result.limbs_[i + y.limbs_.size()] = static_cast<std::uint32_t>(carry);
  }
  result.strip();
  return result;
}

inline Exact::Leading Exact::leading_bits(const Exact& numerator, const Exact& denominator) {
  // Long division in base 2, on whole numbers of one size (least significant limb first). The
  // divisor ends one limb below the top, which is room to double into, and the numerator another
  // limb lower: so the rest starts below the divisor.
  const std::size_t size = std::max(numerator.limbs_.size() + 1, denominator.limbs_.size()) + 1;
  const auto ending_at = [size](std::size_t end, const Limbs& limbs) {
    Limbs wide(size, 0);
    std::copy_backward(limbs.begin(), limbs.end(), wide.begin() + static_cast<std::ptrdiff_t>(end));
    return wide;
  };
  Limbs rest = ending_at(size - 2, numerator.limbs_);
  const Limbs divisor = ending_at(size - 1, denominator.limbs_);
  const auto at_least_divisor = [&] {
    return !std::lexicographical_compare(rest.rbegin(), rest.rend(), divisor.rbegin(),
                                         divisor.rend());
  };
  const auto subtract_divisor = [&] {
    std::uint64_t borrow = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const std::uint64_t difference = std::uint64_t{rest[i]} - divisor[i] - borrow;
      rest[i] = static_cast<std::uint32_t>(difference);
      borrow = difference >> 63;
    }
  };
  const auto double_rest = [&] {
    std::uint32_t carry = 0;
    for (std::uint32_t& limb : rest) {
      const std::uint32_t out = limb >> 31;
      limb = limb << 1 | carry;
      carry = out;
    }
  };

  std::int64_t exponent = 32 * (numerator.top() - denominator.top() + 1);
  std::uint64_t bits = 0;
  while ((bits >> 63) == 0) {
    double_rest();
    --exponent;
    bits <<= 1;
    if (at_least_divisor()) {
      subtract_divisor();
      bits |= 1;
    }
  }
  if (std::any_of(rest.begin(), rest.end(), [](auto limb) { return limb != 0; })) bits |= 1;
  return {bits, exponent};
}

template <class Float>
Float Exact::round_to_even(std::uint64_t bits, std::int64_t exponent) {
  using Limits = std::numeric_limits<Float>;
  static_assert(Limits::digits < 62,
                "the 64 bits must hold the result, a bit to round by and the sticky bit");
  while ((bits >> 63) == 0) {
    bits <<= 1;
    --exponent;
  }
  // Keep as many bits as the format has at this magnitude: fewer and fewer below the smallest
  // normal number.
  const std::int64_t smallest = Limits::min_exponent - Limits::digits;
  const std::int64_t cut = std::max<std::int64_t>(64 - Limits::digits, smallest - exponent);
  if (cut > 64) return Float(0);
  if (exponent > Limits::max_exponent) return Limits::infinity();
  const std::uint64_t half = std::uint64_t{1} << (cut - 1);
  std::uint64_t kept = cut == 64 ? 0 : bits >> cut;
  const std::uint64_t lost = cut == 64 ? bits : bits & ((half << 1) - 1);
  if (lost > half || (lost == half && (kept & 1) != 0)) ++kept;
  return std::ldexp(static_cast<Float>(kept), static_cast<int>(exponent + cut));
}

namespace detail {

/// What Eigen asks of a number type that never rounds, and about how many additions of doubles its
/// operations cost.
template <class Number, int Read, int Add, int Multiply>
struct EigenTraits {
  using Real = Number;
  using NonInteger = Number;
  using Nested = Number;
  using Literal = Number;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = Read,
    AddCost = Add,
    MulCost = Multiply
  };
  static int digits10() { return 0; }
};

}  // namespace detail

}  // namespace contact

namespace Eigen {
template <class T>
struct NumTraits;

/// Lets Eigen's vectors hold `contact::Exact`. Only declared here, so that this header does not
/// need Eigen.
template <>
struct NumTraits<contact::Exact> : contact::detail::EigenTraits<contact::Exact, 4, 40, 60> {};
}  // namespace Eigen
