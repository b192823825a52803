/// @file
/// The angle between two vectors, accurate for small angles too.
#pragma once

#include <cmath>
#include <concepts>
#include <contact/products.hpp>
#include <contact/vector.hpp>
#include <optional>

namespace contact {

namespace angle_detail {

/// v times the power of two that brings its largest coordinate into [1/2, 1), and that power; only
/// coordinates far too small to matter are rounded. 0 for 0.
template <std::floating_point S>
Vector3<S> near_one(const Vector3<S>& v, int& power) {
  power = 0;
  const S largest = v.cwiseAbs().maxCoeff();
  if (largest > S(0)) std::frexp(largest, &power);
  return {std::ldexp(v.x(), -power), std::ldexp(v.y(), -power), std::ldexp(v.z(), -power)};
}

}  // namespace angle_detail

// [angle-between]
/// |u × v| and u · v, both times the same positive number.
template <std::floating_point S>
struct BothProducts {
  S cross_norm;  ///< proportional to the sine of the angle
  S dot;         ///< proportional to its cosine
};

/// Both products of two vectors that are not 0, without overflow.
template <std::floating_point S>
BothProducts<S> both_products(const Vector3<S>& u, const Vector3<S>& v) {
  int power = 0;
  const Vector3<S> a = angle_detail::near_one(u, power);
  const Vector3<S> b = angle_detail::near_one(v, power);
  // The cross product of nearly parallel vectors may be so short that its squares underflow.
  const Vector3<S> c = angle_detail::near_one(cross_accurately(a, b), power);
  return {std::ldexp(std::sqrt(c.dot(c)), power), dot_recursive(a, b)};
}

/// The angle between two vectors, from 0 to π, in radians; nothing if one of them is 0.
///
/// It is computed from both products, tan θ = |u × v| / u · v. Near 0 and π, where the cosine is
/// flat, the cross product determines it, and where the sine is flat the dot product. The relative
/// error is at most 12 u (u the unit roundoff) for all lengths and angles, unless the result is
/// near or below the smallest normal number, where there are fewer digits.
/// @param u any finite vector, in any unit
/// @param v any finite vector, in any unit
///
/// Limits: the last bit may differ from machine to machine, with `std::atan2`.
///
/// Source: Kahan, *How Futile are Mindless Assessments of Roundoff in Floating-Point Computation?*
/// (2006), section 12, on mangled angles, with another formula for the same end.
template <std::floating_point S>
std::optional<S> angle_between(const Vector3<S>& u, const Vector3<S>& v) {
  const Vector3<S> zero = Vector3<S>::Zero();
  if (u == zero || v == zero) return std::nullopt;
  const BothProducts<S> both = both_products(u, v);
  return std::atan2(both.cross_norm, both.dot);
}
// [/angle-between]

}  // namespace contact
