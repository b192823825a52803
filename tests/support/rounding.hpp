/// @file
/// What rounding may do to a number, as fractions: what the bounds in the references' tests are
/// made of.
#pragma once

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <concepts>

#include <contact/tolerance.hpp>

#include "support/oracle.hpp"

namespace rounding {

using oracle::Rational;

/// The unit roundoff u of a type: 2^-24 or 2^-53.
template <std::floating_point S>
Rational u() {
  return oracle::exact(contact::tolerance::unit_roundoff<S>);
}
/// Its smallest positive number η.
template <std::floating_point S>
Rational eta() {
  return oracle::exact(contact::tolerance::underflow_unit<S>);
}
/// γ(n) = n u / (1 − n u), exactly: what n roundings in a row may do.
template <std::floating_point S>
Rational gamma(int n) {
  return n * u<S>() / (1 - n * u<S>());
}

/// The number of the type that is nearest to x, ties to even.
template <std::floating_point S>
S nearest(const Rational& x) {
  if constexpr (sizeof(S) == sizeof(float)) {
    return oracle::nearest_float(x);
  } else {
    return oracle::nearest(x);
  }
}

/// |got - right|, rounded up. A got that is not finite fails the test.
template <std::floating_point S>
Rational error(S got, const Rational& right) {
  const double distance = oracle::error(static_cast<double>(got), right);
  REQUIRE(std::isfinite(distance));
  return oracle::exact(distance);
}

}  // namespace rounding
