/// @file
/// Random motions in fractions.
#pragma once

#include "support/generators.hpp"
#include "support/oracle.hpp"

namespace reference {

using generators::Random;
using oracle::Rational;

/// A fraction with a small denominator, from −bound to bound.
inline Rational fraction(Random& random, int bound) {
  const int denominator = random.integer(1, 12);
  return Rational(random.integer(-bound * denominator, bound * denominator)) / denominator;
}

inline Rational positive(Random& random, int bound) {
  const int denominator = random.integer(1, 12);
  return Rational(random.integer(1, bound * denominator)) / denominator;
}

inline oracle::Vector point(Random& random, int bound) {
  const Rational x = fraction(random, bound);
  const Rational y = fraction(random, bound);
  const Rational z = fraction(random, bound);
  return {x, y, z};
}

}  // namespace reference
