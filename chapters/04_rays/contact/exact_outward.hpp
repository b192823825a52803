/// @file
/// Exact numbers and doubles rounded up or down to the type that is stored.
#pragma once

#include <cmath>
#include <limits>

#include <contact/exact.hpp>
#include <contact/exact_ray_triangle.hpp>

namespace contact {

// [exact-outward]
/// The smallest number of the type that is at least x: ∞ beyond the largest one, and the lowest
/// finite number below that, so that the result is an upper bound in every case.
template <FloatOrDouble S>
S upward(const Exact& x) {
  using Limits = std::numeric_limits<S>;
  const S near = rounded<S>(x);
  if (!std::isfinite(near)) return near > S(0) ? near : Limits::lowest();
  return Exact(static_cast<double>(near)) < x ? std::nextafter(near, Limits::infinity()) : near;
}

/// The largest number of the type that is at most x; −∞ below the lowest one, and the largest
/// number above that.
template <FloatOrDouble S>
S downward(const Exact& x) {
  return -upward<S>(-x);
}
// [/exact-outward]

/// The smallest number of the type that is at least a double: out of range as above; ±∞ for ±∞, NaN
/// for NaN.
template <FloatOrDouble S>
S upward(double x) {
  const S near = static_cast<S>(x);
  return static_cast<double>(near) < x ? std::nextafter(near, std::numeric_limits<S>::infinity())
                                       : near;
}

/// The largest number of the type that is at most a double: likewise.
template <FloatOrDouble S>
S downward(double x) {
  return -upward<S>(-x);
}

}  // namespace contact
