/// @file
/// Random lines that are hard for balls and boxes, and answers about them in fractions.
#pragma once

#include <support/generators.hpp>
#include <support/oracle.hpp>

#include <algorithm>
#include <boost/multiprecision/eigen.hpp>
#include <contact/passage.hpp>
#include <limits>
#include <optional>

namespace rays {

using contact::Ray;
using contact::Segment;
using contact::Vector3;
using generators::Random;
using oracle::Rational;

/// Kinds of input, by number: random; whole numbers; a few ulps beside a coincidence; far from the
/// body; long and short directions; the size 1e-150 to 1e150; any bit pattern.
inline constexpr int kinds = 7;

template <class S>
S nudged(Random& random, S x, int most = 2) {
  for (int n = random.integer(0, most); n > 0; --n) {
    x = std::nextafter(x, random.chance(0.5) ? std::numeric_limits<S>::infinity()
                                             : -std::numeric_limits<S>::infinity());
  }
  return x;
}

template <class S>
Vector3<S> nudged(Random& random, const Vector3<S>& v) {
  return {nudged(random, v.x()), nudged(random, v.y()), nudged(random, v.z())};
}

/// A coordinate of a kind, before sizes and positions are applied.
template <class S>
S coordinate(Random& random, int kind) {
  if (kind == 6) return generators::any_finite<S>(random);
  if (kind == 1 || kind == 2) return S(random.integer(-6, 6));
  return S(random.uniform(-1, 1));
}
template <class S>
Vector3<S> vector(Random& random, int kind) {
  return {coordinate<S>(random, kind), coordinate<S>(random, kind), coordinate<S>(random, kind)};
}

/// A power of two of the type that keeps products of a few such numbers in or out of range.
template <class S>
S size(Random& random, int kind) {
  const int most = std::is_same_v<S, float> ? 60 : 500;
  return kind == 5 ? std::ldexp(S(1), random.integer(-most, most)) : S(1);
}

/// A ray of a kind that points near `target`.
template <class S>
Ray<S> ray_towards(Random& random, int kind, const Vector3<S>& target, S scale) {
  Ray<S> ray{Vector3<S>(vector<S>(random, kind) * scale),
             Vector3<S>(vector<S>(random, kind) * scale)};
  if (kind == 6) return ray;
  if (random.chance(0.6)) ray.direction = target - ray.origin;
  if (kind == 1 && random.chance(0.3)) ray.direction = Vector3<S>::Unit(random.integer(0, 2));
  if (kind == 2) {
    ray.origin = nudged<S>(random, ray.origin);
    ray.direction = nudged<S>(random, ray.direction);
  }
  if (kind == 3) {
    const S far = std::ldexp(S(1), random.integer(1, std::is_same_v<S, float> ? 20 : 60));
    ray.origin = ray.origin - ray.direction * far;
  }
  if (kind == 4) {
    ray.direction *= std::ldexp(S(1), random.integer(std::is_same_v<S, float> ? -60 : -600,
                                                     std::is_same_v<S, float> ? 60 : 600));
  }
  if (random.chance(0.05)) ray.direction(random.integer(0, 2)) = S(0);
  if (random.chance(0.02)) ray.direction = -ray.direction;
  if (random.chance(0.01)) ray.direction = Vector3<S>::Zero();
  return ray;
}

/// Whether every number is finite, for those that products made.
template <class S>
bool usable(const Ray<S>& ray) {
  return contact::is_finite(ray);
}

/// The stored line in fractions.
template <class S>
Ray<Rational> exact_line(const Ray<S>& ray) {
  return oracle::exact(ray);
}
template <class S>
Ray<Rational> exact_line(const Segment<S>& segment) {
  const auto s = oracle::exact(segment);
  return {s.start, Vector3<Rational>(s.end - s.start)};
}

/// Whether got is the exact t to within the share of `largest` and, in float, a rounding.
template <class S>
bool t_is(S got, const oracle::Surd& right, double largest, double share) {
  const double in_double = oracle::nearest(right);
  if (std::abs(in_double) > 0.999 * double(std::numeric_limits<S>::max())) {
    return std::abs(double(got)) > 0.99 * double(std::numeric_limits<S>::max());
  }
  const double room = std::is_same_v<S, float> ? 0x1p-24 : 0x1p-53;
  return oracle::error(double(got), right) <= share * largest + room * std::abs(in_double) +
                                                  double(std::numeric_limits<S>::denorm_min());
}

}  // namespace rays
