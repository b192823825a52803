/// @file
/// Angles of incidence and of rebound, both from the normal.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <numbers>

#include <contact/vector.hpp>

namespace contact {

// [arctangent]
/// The angle whose tangent is y / x, for a point of the first quadrant.
///
/// The tangent of half an angle is t / (1 + √(1 + t²)): after three halvings ten terms of Gregory's
/// series are enough. Only +, −, ×, ÷ and √ are used, so every machine gives the same bits.
/// @param y, x not negative, finite
/// @return rad, from 0 to π/2; 0 if both are 0. Off by at most 16 u of itself
template <std::floating_point S>
S arctangent(const S& y, const S& x) {
  const S large = std::max(x, y);
  if (large == S(0)) return S(0);
  S t = std::min(x, y) / large;
  for (int halving = 0; halving < 3; ++halving) t = t / (S(1) + std::sqrt(S(1) + t * t));
  const S square = t * t;
  S sum(0);
  for (int term = 21; term >= 3; term -= 2) sum = square * (S(1) / S(term) - sum);
  const S angle = S(8) * (t - t * sum);
  return y <= x ? angle : std::numbers::pi_v<S> / S(2) - angle;
}
// [/arctangent]

// [angle-from-normal]
/// The angle between the line of a velocity and the normal: 0 head-on, π/2 along the surface. It
/// serves for incidence and rebound, as it does not depend on the direction along the line.
/// @param velocity m/s
/// @param normal unit vector
/// @return rad, from 0 to π/2; 0 for a velocity of 0. Off by at most 32 u
/// @note A slide says "with respect to the vertical": the two agree only if the floor is level.
template <std::floating_point S>
S angle_from_normal(const Vector3<S>& velocity, const Vector3<S>& normal) {
  const S largest = velocity.cwiseAbs().maxCoeff();
  if (!(largest > S(0))) return S(0);
  const Vector3<S> v = velocity / largest;
  return arctangent(S(v.cross(normal).norm()), S(std::abs(v.dot(normal))));
}
// [/angle-from-normal]

/// Radians as degrees.
template <std::floating_point S>
S degrees(const S& radians) {
  return radians * S(180) / std::numbers::pi_v<S>;
}

}  // namespace contact
