/// @file
/// Numbers with one square root: their sign, and the root itself in double.
#pragma once

#include <cmath>
#include <contact/exact.hpp>

namespace contact {

namespace detail {

// [sign-with-root]
/// The sign of a + b √d, for d ≥ 0: by squaring.
inline int sign_with_root(const Exact& a, const Exact& b, const Exact& d) {
  const int of_a = a.sign();
  const int of_b = d.sign() == 0 ? 0 : b.sign();
  if (of_a * of_b >= 0) return of_a != 0 ? of_a : of_b;
  const int larger = (a * a - b * b * d).sign();
  return larger >= 0 ? (larger == 0 ? 0 : of_a) : of_b;
}
// [/sign-with-root]

/// x 2^n, for the n of a double's exponents.
inline Exact times_power_of_two(const Exact& x, int n) {
  const int half = n / 2;
  return x * Exact(std::ldexp(1.0, half)) * Exact(std::ldexp(1.0, n - half));
}

/// √(n/d) for n ≥ 0 and d > 0, to two roundings; also where the quotient is out of a double's range
/// but its root is not.
inline double root_of_quotient(Exact n, const Exact& d) {
  constexpr int step = 1200;  // even
  int k = 0;
  double q = quotient<double>(n, d);
  for (; std::isinf(q); k += step) q = quotient<double>(n = times_power_of_two(n, -step), d);
  for (; q < 0x1p-900 && n.sign() != 0; k -= step) {
    q = quotient<double>(n = times_power_of_two(n, step), d);
  }
  return std::ldexp(std::sqrt(q), k / 2);
}

}  // namespace detail

}  // namespace contact
