/// @file
/// Numbers of so few digits that a discriminant in double is exact, as for whole numbers.
#pragma once

#include <algorithm>
#include <cmath>

#include <contact/error_free.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>

namespace contact::detail {

/// Whether all four numbers are multiples of some 2^e and below 2^(e + 11), or all are 0; not for
/// sizes beyond 2^±100.
///
/// x + 1.5·2^42 s − 1.5·2^42 s = x only if x is a multiple of the last place of 1.5·2^42 s (or,
/// with carry, of twice that), which is at least 2^-11 of the largest magnitude s.
inline bool have_few_digits(const Vector3<double>& v, double w) {
  const double size = std::max(v.cwiseAbs().maxCoeff(), std::abs(w));
  const double shift = 0x1.8p42 * size;
  bool all = size == 0 || (0x1p-100 <= size && size <= 0x1p100);
  for (const double x : {v.x(), v.y(), v.z(), w}) all &= (x + shift) - shift == x;
  return all;
}

// [few-digits]
/// Whether a, b, c and b² − a c of a ray and a proper ball are exact in double, however they are
/// added up: true for whole numbers up to a thousand and for others of so few digits.
///
/// Then m = origin − centre is exact, m and r are whole numbers below 2^11 in some unit, and d in
/// another one; a < 2^24, |b| < 2^24 and |c| < 2^25 in products of these units, and b² and a c are
/// below 2^49.
inline bool terms_are_exact(const Ray<double>& ray, const Sphere<double>& sphere) {
  if (!(sphere.radius >= 0)) return false;
  for (int k = 0; k < 3; ++k) {
    if (two_sum(ray.origin(k), -sphere.centre(k)).error != 0) return false;
  }
  return have_few_digits(ray.origin - sphere.centre, sphere.radius) &&
         have_few_digits(ray.direction, 0);
}
// [/few-digits]

}  // namespace contact::detail
