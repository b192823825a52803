/// @file
/// The sign of a number with one square root.
#pragma once

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

}  // namespace detail

}  // namespace contact
