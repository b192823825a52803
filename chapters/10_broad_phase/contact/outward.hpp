/// @file
/// Sums that are rounded in a direction of our choice: what an enclosure is made with.
#pragma once

#include <cmath>
#include <concepts>
#include <limits>

#include <contact/error_free.hpp>

namespace contact {

// [outward]
/// The smallest number of the type that is not below a + b.
///
/// The sum is rounded to nearest; what two_sum() says it lost decides whether to go up by one. A
/// sum never underflows with an error, so this is exact directed rounding.
/// @param a, b finite
/// @return ∞ if a + b is beyond the largest number; the lowest finite number if it is below that
///
/// Source: Rump, Zimmermann, Boldo and Melquiond, *Computing predecessor and successor in rounding
/// to nearest*, BIT Numerical Mathematics 49 (2009), for the idea.
template <std::floating_point S>
S sum_up(S a, S b) {
  using Limits = std::numeric_limits<S>;
  const WithError<S> sum = two_sum(a, b);
  if (!std::isfinite(sum.value)) return sum.value > S(0) ? sum.value : Limits::lowest();
  // An error that is not a number comes from numbers next to the largest: one step covers it.
  return sum.error <= S(0) ? sum.value : std::nextafter(sum.value, Limits::infinity());
}

/// The largest number of the type that is not above a + b: sum_up() seen from the other side.
/// @param a, b finite
template <std::floating_point S>
S sum_down(S a, S b) {
  return -sum_up(-a, -b);
}
// [/outward]

}  // namespace contact
