/// @file
/// Sums rounded up or down (directed rounding), for enclosures.
#pragma once

#include <cmath>
#include <concepts>
#include <limits>

#include <contact/error_free.hpp>

namespace contact {

// [outward]
/// The smallest floating-point number that is at least a + b.
///
/// The sum is rounded to nearest; its rounding error, from two_sum(), decides whether to take the
/// next number up. A sum never underflows with an error, so this is exact directed rounding.
/// @param a, b finite
/// @return ∞ if a + b is beyond the largest number; the lowest finite number if it is below that.
/// NaN if a number is NaN, or if one is ∞ and the other −∞
///
/// Source: Rump, Zimmermann, Boldo and Melquiond, *Computing predecessor and successor in rounding
/// to nearest*, BIT Numerical Mathematics 49 (2009), for the idea.
template <std::floating_point S>
S sum_up(S a, S b) {
  using Limits = std::numeric_limits<S>;
  const WithError<S> sum = two_sum(a, b);
  if (!std::isfinite(sum.value)) return sum.value < S(0) ? Limits::lowest() : sum.value;
  // An error that is NaN comes from numbers next to the largest: the next number up is a bound.
  return sum.error <= S(0) ? sum.value : std::nextafter(sum.value, Limits::infinity());
}

/// The largest floating-point number that is at most a + b.
/// @param a, b finite
template <std::floating_point S>
S sum_down(S a, S b) {
  return -sum_up(-a, -b);
}
// [/outward]

}  // namespace contact
