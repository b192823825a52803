/// @file
/// An angle from its sine and cosine, bit-identical on every machine.
#pragma once

#include <cmath>

namespace contact {

/// The angle from 0 to π whose sine and cosine have the ratio `y` to `x`, as std::atan2
/// gives it for across ≥ 0. It uses + − × / and square roots only, so that native code and the page
/// agree to the bit.
///
/// The tangent of an angle up to π/4 is halved three times, tan θ/2 = tan θ / (1 + √(1 + tan²θ)),
/// to less than 1/10. Ten terms of the series of the arctangent suffice: the next is below u.
/// @param y at least 0, in any unit; finite
/// @param x in the same unit; finite
/// @return radians; 0 if both are 0
///
/// Limits: the relative error is at most 16 u, plus four times the smallest positive number. One
/// rounding is that of the tangent; each halving adds three of full weight (the square in 1 + t²
/// has less), and the series the rest. The result is not guaranteed to be monotonic: it may stay
/// the same or decrease if `y` grows by one ulp.
inline double portable_angle(double y, double x) {
  constexpr double pi = 3.141592653589793;
  const double size = std::abs(x);
  if (y == 0 && size == 0) return 0;
  const bool steep = y > size;
  double t = steep ? size / y : y / size;
  for (int half = 0; half < 3; ++half) t /= 1 + std::sqrt(1 + t * t);
  double series = 0;
  for (int n = 19; n >= 1; n -= 2) series = 1.0 / n - t * t * series;
  const double acute = steep ? pi / 2 - 8 * t * series : 8 * t * series;
  return x < 0 ? pi - acute : acute;
}

}  // namespace contact
