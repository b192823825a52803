/// @file
/// Points that move in straight lines about the origin: how long a plane certainly separates all of
/// them from it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <contact/running_error.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact::detail {

/// The differences of N pairs of points that move in straight lines, times a power of two so that
/// none is longer than √3.
///
/// The bodies of the pairs meet when the origin is in the convex hull of the differences (of the
/// Minkowski difference). Each stored coordinate is off by at most u of itself and η.
template <std::size_t N>
struct MovingDifferences {
  std::array<Vector3<double>, N> start;  ///< at t = 0
  std::array<Vector3<double>, N> end;    ///< at t = 1
  /// Whether no difference overflowed and not all are 0.
  bool usable = false;

  /// The difference i at the time t, rounded.
  Vector3<double> at(std::size_t i, double t) const { return start[i] * (1 - t) + end[i] * t; }
  /// Multiplies by a power of two so that the largest coordinate is at least 1/2 and below 1.
  void scale() {
    double size = 0;
    usable = true;
    for (std::size_t i = 0; i < N; ++i) {
      size = std::max({size, start[i].cwiseAbs().maxCoeff(), end[i].cwiseAbs().maxCoeff()});
      usable = usable && all_finite(start[i]) && all_finite(end[i]);
    }
    usable = usable && size > 0;
    if (!usable) return;
    int power = 0;
    std::frexp(size, &power);
    const bool in_one = power > -1000 && power < 1000;
    const double factor = in_one ? std::ldexp(1.0, -power) : 0;
    for (Vector3<double>* v = start.data(); v != start.data() + N; ++v) scale(*v, factor, power);
    for (Vector3<double>* v = end.data(); v != end.data() + N; ++v) scale(*v, factor, power);
  }

 private:
  static void scale(Vector3<double>& v, double factor, int power) {
    for (int k = 0; k < 3; ++k) v(k) = factor > 0 ? v(k) * factor : std::ldexp(v(k), -power);
  }
};

/// How long a plane through the origin separates it.
struct SeparatingTime {
  double until = 0;     ///< all differences are strictly in front of the plane before this time
  bool always = false;  ///< and up to the end of the step
};

// [separating-time]
/// How long all differences are strictly in front of the plane through the origin with the normal
/// n, from the time `from` on.
///
/// n · x is linear in the time for each difference. Its computed values at both ends, less 2^-50 of
/// the magnitudes of their terms, are below the exact ones: each term has five roundings, that of
/// the stored coordinate included, and γ(5) < 2^-50 leaves as much for the magnitudes and the
/// subtraction; 2^-1000 is more than what underflow takes from any of them. So the line through the
/// two lower values is below n · x at all times between, and where it is above 0, so is n · x. Its
/// zero has three roundings, and none cancels, because one value is above 0 and the other is not: a
/// factor 1 ∓ 8u bounds it.
///
/// A later time therefore proves that the origin was outside the convex hull of the differences
/// from `from` until then.
/// @return `until` = from if the plane proves nothing at `from`
template <std::size_t N>
SeparatingTime separating_time(const MovingDifferences<N>& x, const Vector3<double>& n,
                               double from) {
  constexpr double u = tolerance::unit_roundoff<double>;
  SeparatingTime separated{1, true};
  for (std::size_t i = 0; i < N; ++i) {
    const auto below = [&n](const Vector3<double>& p) {
      const double a = n[0] * p[0], b = n[1] * p[1], c = n[2] * p[2];
      return (a + b + c) - (0x1p-50 * (std::abs(a) + std::abs(b) + std::abs(c)) + 0x1p-1000);
    };
    const double first = below(x.start[i]), last = below(x.end[i]);
    if (!(first > 0) && !(last > 0)) return {from, false};
    if (!(first > 0) && !(-first / (last - first) * (1 + 8 * u) < from)) return {from, false};
    if (last > 0) continue;
    separated.always = false;
    separated.until = std::min(separated.until, first / (first - last) * (1 - 8 * u));
  }
  if (!(separated.until > from) && !separated.always) return {from, false};
  return separated;
}
// [/separating-time]

/// Three numbers with a bound of their error: the difference i at any time from t − w to t + w.
template <std::size_t N>
Triple<RunningError> enclosed(const MovingDifferences<N>& x, std::size_t i, double t, double w) {
  constexpr double u = tolerance::unit_roundoff<double>;
  Triple<RunningError> point;
  for (int k = 0; k < 3; ++k) {
    const double p = x.start[i](k), q = x.end[i](k);
    // p + (q − p) t: q − p is off by 3 u (|p| + |q|) at most, and so is what follows from it.
    const double size = std::abs(p) + std::abs(q);
    const double rate = q - p;
    point[static_cast<std::size_t>(k)] = {
        p + rate * t,
        (std::abs(rate) + 4 * u * size) * w * (1 + 16 * u) + 16 * u * size + 0x1p-1000};
  }
  return point;
}

}  // namespace contact::detail
