/// @file
/// The real roots of a quadratic, without cancellation and without intermediate overflow or
/// underflow.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <utility>

#include <contact/products.hpp>

namespace contact {

/// The real roots of a quadratic.
template <std::floating_point S>
struct QuadraticRoots {
  int count = 0;  ///< 0, 1 (a double root, or that of a linear equation) or 2
  S low = S(0);   ///< the smaller root; 0 if there is none
  S high = S(0);  ///< the larger root; the same as low if there is one
};

namespace detail {

/// The roots of a t² + b t + c with 1/2 ≤ |a| < 2, 1 ≤ |c| < 2 and |b| < 2^61.
template <std::floating_point S>
QuadraticRoots<S> scaled_roots(S a, S b, S c) {
  // Kahan's difference of products has the right sign, and is 0 only for a double root.
  const S discriminant = difference_of_products(b, b, S(4) * a, c);
  if (discriminant < S(0)) return {};
  if (discriminant == S(0)) {
    const S twice = -b / a / S(2);
    return {1, twice, twice};
  }
  const S root = std::sqrt(discriminant);
  // b and the root are added with the same sign: nothing cancels.
  const S sum = b < S(0) ? b - root : b + root;
  const S one = -sum / a / S(2);
  const S other = S(-2) * c / sum;
  return {2, std::min(one, other), std::max(one, other)};
}

}  // namespace detail

// [quadratic-roots]
/// The real roots of a t² + b t + c.
///
/// The textbook formula loses digits if b² is much larger than 4 a c, because it subtracts two
/// nearly equal numbers. Here the root of larger magnitude is computed first, and the other from
/// their product, c / a. The discriminant is a difference of two products, computed by Kahan's
/// algorithm with a relative error of 2 u. Before that t is scaled by a power of two, so that a and
/// c have about the same magnitude.
/// @param a, b, c finite, as stored
/// @return the number of roots is right for all finite input. Each root has a relative error of at
/// most 8 u, or an absolute error of the smallest positive number. A root beyond the largest finite
/// number is ±∞. For a = 0 the equation is linear; a = b = 0 gives no root, even if c = 0; nor do
/// coefficients that are not finite.
///
/// Source: Higham, *Accuracy and Stability of Numerical Algorithms*, 2nd edition, section 1.8.
template <std::floating_point S>
QuadraticRoots<S> quadratic_roots(const S& a, const S& b, const S& c) {
  if (!is_finite(a) || !is_finite(b) || !is_finite(c)) return {};
  if (a == S(0)) {
    if (b == S(0)) return {};
    const S root = c == S(0) ? S(0) : -c / b;
    return {1, root, root};
  }
  if (c == S(0)) {
    const S other = b == S(0) ? S(0) : -b / a;
    if (b == S(0)) return {1, S(0), S(0)};
    return {2, std::min(S(0), other), std::max(S(0), other)};
  }
  // t = 2^k s, and all three divided by c's power of two: a and c then have similar magnitudes.
  const int of_a = std::ilogb(a);
  const int of_c = std::ilogb(c);
  const int difference = of_c - of_a;
  const int k = (difference - (difference < 0 ? 1 : 0)) / 2;
  const int rest = difference - 2 * k;  // 0 or 1
  if (b != S(0) && std::ilogb(b) + k - of_c > 60) {
    // b² is at least 2^117 times 4 a c: the contribution of the other coefficient is below the
    // rounding of a root.
    const S one = -b / a;
    const S other = -c / b;
    return {2, std::min(one, other), std::max(one, other)};
  }
  QuadraticRoots<S> roots = detail::scaled_roots(std::ldexp(a, -of_a - rest),
                                                 std::ldexp(b, k - of_c), std::ldexp(c, -of_c));
  roots.low = std::ldexp(roots.low, k);
  roots.high = std::ldexp(roots.high, k);
  return roots;
}
// [/quadratic-roots]

}  // namespace contact
