/// @file
/// Sine and cosine with the same bits on every machine.
#pragma once

#include <cmath>
#include <concepts>

namespace contact {

/// A sine and a cosine.
template <std::floating_point S>
struct SineCosine {
  S sine = S(0);    ///< from −1 to 1
  S cosine = S(1);  ///< from −1 to 1
};

// [sine-cosine]
/// sin x and cos x from additions and products alone, so that the bits are the same on every
/// machine.
///
/// x is reduced by full turns without rounding, then by quarter turns; the remainder is at most an
/// eighth of a turn, for which a short series is enough. The stored 2π is off by at most half an
/// ulp, so the result is that of an x that is off by at most u of itself.
/// @param x rad, finite
/// @return off by a few u, and by u |x|
template <std::floating_point S>
SineCosine<S> sine_cosine(const S& x) {
  constexpr double two_pi = 6.283185307179586;
  constexpr double quarter = 1.5707963267948966;
  constexpr double quarter_rest = 6.123233995736766e-17;
  const double turned = std::remainder(static_cast<double>(x), two_pi);
  const double n = std::nearbyint(turned / quarter);
  const double r = (turned - n * quarter) - n * quarter_rest;
  const double r2 = r * r;
  double s = 0;
  double c = 0;
  for (int k = 9; k >= 1; --k) {
    s = -r2 * (1 + s) / (2 * k * (2 * k + 1));
    c = -r2 * (1 + c) / (2 * k * (2 * k - 1));
  }
  const double sine = r * (1 + s);
  const double cosine = 1 + c;
  switch (static_cast<int>(n) & 3) {
    case 0:
      return {S(sine), S(cosine)};
    case 1:
      return {S(cosine), S(-sine)};
    case 2:
      return {S(-sine), S(-cosine)};
    default:
      return {S(-cosine), S(sine)};
  }
}
// [/sine-cosine]

}  // namespace contact
