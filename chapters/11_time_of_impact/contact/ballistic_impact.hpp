/// @file
/// The time at which a sphere in free fall reaches a plane, as the root of a quadratic.
#pragma once

#include <cmath>
#include <concepts>
#include <optional>

#include <contact/entry_time.hpp>
#include <contact/exact.hpp>
#include <contact/plane.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>

namespace contact {

/// The position after a time under constant acceleration: x + (v + (a t) / 2) t.
/// @param position m
/// @param velocity at the start, m for each unit of time
/// @param acceleration m for each square of that unit
/// @param t in that unit: steps, or s
template <Scalar S>
Vector3<S> ballistic_position(const Vector3<S>& position, const Vector3<S>& velocity,
                              const Vector3<S>& acceleration, const S& t) {
  return position + (velocity + acceleration * (t / S(2))) * t;
}

namespace detail {

/// The distance of a sphere from a plane under gravity: gap + rate t + bend t²/2.
template <Ring T>
struct FallTerms {
  T gap;           ///< n · c − k − r, m
  T rate;          ///< n · v, m/s
  T acceleration;  ///< n · g, m/s²
  T depth() const { return rate * rate - (acceleration * gap + acceleration * gap); }
};

/// The root of larger magnitude, |rate| + √depth over |bend|, where nothing cancels.
template <std::floating_point S>
S sum_over_acceleration(const FallTerms<Exact>& f, const Exact& depth) {
  const Exact rate = abs(f.rate);
  const Exact acceleration = abs(f.acceleration);
  if (rate * rate <= depth) {  // √depth is the larger term
    const S share = quotient<S>(rate * rate, depth);
    return std::sqrt(quotient<S>(depth, acceleration * acceleration)) * (S(1) + std::sqrt(share));
  }
  return quotient<S>(rate, acceleration) * (S(1) + std::sqrt(quotient<S>(depth, rate * rate)));
}

/// The other root: 2 gap / (|rate| + √depth).
template <std::floating_point S>
S gap_over_sum(const FallTerms<Exact>& f, const Exact& depth) {
  const Exact rate = abs(f.rate);
  const Exact twice = abs(f.gap + f.gap);
  if (rate * rate <= depth) {
    const S share = quotient<S>(rate * rate, depth);
    return std::sqrt(quotient<S>(twice * twice, depth)) / (S(1) + std::sqrt(share));
  }
  return quotient<S>(twice, rate) / (S(1) + std::sqrt(quotient<S>(depth, rate * rate)));
}

/// The first time at which the gap is closed and shrinks.
template <std::floating_point S>
std::optional<S> fall_time(const FallTerms<Exact>& f) {
  const int gap = f.gap.sign();
  const int rate = f.rate.sign();
  const int acceleration = f.acceleration.sign();
  if (gap <= 0 && (rate < 0 || (rate == 0 && acceleration < 0))) return S(0);
  const Exact depth = f.depth();
  if (acceleration < 0) {
    // The sphere falls back in the end. If it rises without separating, the time is that of its
    // highest point.
    if (depth.sign() < 0) return quotient<S>(f.rate, -f.acceleration);
    return rate >= 0 ? sum_over_acceleration<S>(f, depth) : gap_over_sum<S>(f, depth);
  }
  if (gap <= 0 || rate >= 0 || depth.sign() < 0) return std::nullopt;
  return gap_over_sum<S>(f, depth);
}

}  // namespace detail

// [ballistic-impact]
/// The time at which a sphere in free fall hits a plane: the first t ≥ 0 at which the distance of
/// its centre from the plane is at most the radius and decreases.
///
/// The gap n·c − k − r + n·v t + n·g t²/2 is a quadratic. Its three coefficients are computed
/// exactly, so the decision is right, and no digits are lost near a floor. The root is the one at
/// which the gap closes.
///
/// A sphere that touches gives 0 if it approaches, or if it is at rest and accelerated towards the
/// plane. A sphere that moves away from the plane, or from a little behind it, gives the time at
/// which it is back; if it does not separate, the time at which it stops moving away. A sphere that
/// lies on the plane without acceleration gives nothing.
/// @param sphere at t = 0, m, finite, with a radius that is not negative
/// @param velocity at t = 0, times the step: its displacement without gravity, m, finite
/// @param gravity constant acceleration times the square of the step, m, finite; 0 is allowed. With
/// a velocity in m/s and an acceleration in m/s² the step is 1 s, and t is in s
/// @param plane with a unit normal; the half-space behind it is solid
/// @return t, in steps, without an end: more than 1 is after the step. Nothing if the sphere never
/// hits the plane, or only after the largest finite time. Relative error at most 8 u for times from
/// 2^-500 to 2^500 in double (2^-60 to 2^60 in float)
template <std::floating_point S>
std::optional<S> ballistic_impact(const Sphere<S>& sphere, const Vector3<S>& velocity,
                                  const Vector3<S>& gravity, const Plane<S>& plane) {
  const Vector3<Exact> normal = exact_vector(plane.normal);
  const detail::FallTerms<Exact> terms{
      normal.dot(exact_vector(sphere.centre)) - Exact(double(plane.offset)) -
          Exact(double(sphere.radius)),
      normal.dot(exact_vector(velocity)), normal.dot(exact_vector(gravity))};
  const std::optional<S> time = detail::fall_time<S>(terms);
  if (!time || !std::isfinite(*time)) return std::nullopt;
  return time;
}
// [/ballistic-impact]

}  // namespace contact
