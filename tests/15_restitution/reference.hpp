/// @file
/// Random balls, and bounces in exact fractions with one square root.
#pragma once

#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "support/generators.hpp"
#include "support/oracle.hpp"

namespace reference {

using contact::Vector3;
using generators::Random;
using oracle::Rational;
using oracle::Surd;

template <class S>
Vector3<S> vector(Random& random, int low, int high) {
  return Vector3<S>{S(random.magnitude(low, high)), S(random.magnitude(low, high)),
                    S(random.magnitude(low, high))};
}

template <class S>
Rational error(S got, const Surd& right) {
  const double off = oracle::error(static_cast<double>(got), right);
  REQUIRE(std::isfinite(off));
  return oracle::exact(off);
}

}  // namespace reference
