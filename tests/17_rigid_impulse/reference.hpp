/// @file
/// Random rigid bodies, stored and in exact fractions. Comparisons without tolerance are exact.
#pragma once

#include <contact/inertia.hpp>

#include "support/generators.hpp"
#include "support/oracle.hpp"

namespace reference {

using contact::Matrix3;
using contact::Vector3;
using generators::Random;
using oracle::Rational;
using oracle::Vector;

using Matrix = Matrix3<Rational>;
inline constexpr double u = 0x1p-53;

inline Rational fraction(Random& random) {
  return Rational(random.integer(-40, 40)) / random.integer(1, 9);
}

inline Rational positive(Random& random) {
  return Rational(random.integer(1, 40)) / random.integer(1, 9);
}

inline Vector vector(Random& random) {
  const Rational x = fraction(random);
  const Rational y = fraction(random);
  return {x, y, fraction(random)};
}

/// A rotation with rational entries: that of a quaternion that need not have length 1.
inline Matrix rational_rotation(Random& random) {
  Rational w = random.integer(1, 5);
  const Vector v{Rational(random.integer(-5, 5)), Rational(random.integer(-5, 5)),
                 Rational(random.integer(-5, 5))};
  const Rational length = w * w + v.dot(v);
  Matrix m;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      m(i, k) = 2 * v(i) * v(k);
      if (i == k) m(i, k) += w * w - v.dot(v);
    }
  }
  m(0, 1) -= 2 * w * v(2);
  m(1, 0) += 2 * w * v(2);
  m(0, 2) += 2 * w * v(1);
  m(2, 0) -= 2 * w * v(1);
  m(1, 2) -= 2 * w * v(0);
  m(2, 1) += 2 * w * v(0);
  return m / length;
}

inline Vector3<double> direction(Random& random) {
  for (;;) {
    const Vector3<double> v{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    if (v.norm() > 0.1 && v.norm() <= 1) return v.normalized();
  }
}

}  // namespace reference
