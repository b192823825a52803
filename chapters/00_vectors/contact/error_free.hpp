/// @file
/// The effect of one rounding: the spacing of floating-point numbers, and error-free
/// transformations, which give sums and products together with their rounding errors.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>

namespace contact {

// [ulp]
/// The distance from |x| to the next larger number of its type, one *unit in the last place*.
///
/// It is constant between two powers of two and doubles at each: 2^(e−p+1) for 2^e ≤ |x| < 2^(e+1),
/// where p is 24 for float and 53 for double. Below the smallest normal number it is constant.
/// @param x any number; for the largest finite one it is the distance to the number before it
/// @return in the unit of x; the smallest positive number for 0, ∞ for ±∞, NaN for NaN
template <std::floating_point S>
S ulp(S x) {
  using Limits = std::numeric_limits<S>;
  if (!std::isfinite(x)) return std::abs(x);
  int exponent = Limits::min_exponent;
  if (x != S(0)) std::frexp(x, &exponent);  // |x| in [2^(exponent−1), 2^exponent)
  return std::ldexp(S(1), std::max(exponent, Limits::min_exponent) - Limits::digits);
}
// [/ulp]

/// A rounded result and its rounding error: value + error is the exact result.
template <std::floating_point S>
struct WithError {
  S value;  ///< rounded
  S error;  ///< exact result − value
};

// [two-sum]
/// The rounded sum of two numbers, and its rounding error: value + error = a + b exactly.
///
/// Limits: neither the sum nor an intermediate difference may overflow; a difference can if an
/// argument is near the largest number. Sums do not underflow. Six additions, no branch.
///
/// Source: Knuth, *The Art of Computer Programming*, volume 2, 3rd edition, section 4.2.2, theorem
/// B.
template <std::floating_point S>
WithError<S> two_sum(S a, S b) {
  const S sum = a + b;
  const S b_in_it = sum - a;
  const S a_in_it = sum - b_in_it;
  return {sum, (a - a_in_it) + (b - b_in_it)};
}
// [/two-sum]

// [two-product]
/// The rounded product of two numbers, and its rounding error: value + error = a b exactly.
///
/// A fused multiply-add computes a b − value with one rounding, and this difference is exact.
///
/// Limits: the product neither overflows nor is smaller than 2^(emin + p), where 2^emin is the
/// smallest normal number: 2^-969 for double; below that the error may be off by half the smallest
/// positive number. 0 is exact.
///
/// Source: Ogita, Rump and Oishi, *Accurate sum and dot product*, SIAM Journal on Scientific
/// Computing 26 (2005), algorithm 3.5.
template <std::floating_point S>
WithError<S> two_product(S a, S b) {
  const S product = a * b;
  return {product, std::fma(a, b, -product)};
}
// [/two-product]

}  // namespace contact
