/// @file
/// A sphere in free fall against a plane: when it arrives, as the root of a quadratic.
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

/// Where a body is after a time under constant acceleration: x + (v + (a t) / 2) t.
/// @param position m
/// @param velocity at the beginning, m/s
/// @param acceleration m/s²
/// @param t s
template <Scalar S>
Vector3<S> ballistic_position(const Vector3<S>& position, const Vector3<S>& velocity,
                              const Vector3<S>& acceleration, const S& t) {
  return position + (velocity + acceleration * (t / S(2))) * t;
}

namespace detail {

/// How far a sphere is in front of a plane, as it changes under gravity: gap + rate t + bend t²/2.
template <Ring T>
struct FallTerms {
  T gap;   ///< n · c − k − r, m
  T rate;  ///< n · v, m/s
  T bend;  ///< n · g, m/s²
  T depth() const { return rate * rate - (bend * gap + bend * gap); }
};

/// Where the root of larger magnitude does not cancel: |rate| + √depth, over |bend|.
template <std::floating_point S>
S sum_over_bend(const FallTerms<Exact>& f, const Exact& depth) {
  const Exact rate = abs(f.rate);
  const Exact bend = abs(f.bend);
  if (rate * rate <= depth) {  // √depth leads
    const S share = quotient<S>(rate * rate, depth);
    return std::sqrt(quotient<S>(depth, bend * bend)) * (S(1) + std::sqrt(share));
  }
  return quotient<S>(rate, bend) * (S(1) + std::sqrt(quotient<S>(depth, rate * rate)));
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

/// The first time at which the gap is closed and closing.
template <std::floating_point S>
std::optional<S> fall_time(const FallTerms<Exact>& f) {
  const int gap = f.gap.sign();
  const int rate = f.rate.sign();
  const int bend = f.bend.sign();
  if (gap <= 0 && (rate < 0 || (rate == 0 && bend < 0))) return S(0);
  const Exact depth = f.depth();
  if (bend < 0) {
    // It comes down in the end. If it rises without getting clear, when it begins to come down.
    if (depth.sign() < 0) return quotient<S>(f.rate, -f.bend);
    return rate >= 0 ? sum_over_bend<S>(f, depth) : gap_over_sum<S>(f, depth);
  }
  if (gap <= 0 || rate >= 0 || depth.sign() < 0) return std::nullopt;
  return gap_over_sum<S>(f, depth);
}

}  // namespace detail

// [ballistic-impact]
/// When a sphere in free fall arrives at the front of a plane: the first t ≥ 0 at which the plane
/// is no further from its centre than its radius, while it comes closer.
///
/// The gap n·c − k − r + n·v t + n·g t²/2 is a quadratic. All three coefficients are taken without
/// rounding, so the decision is right, and near a floor no digits are lost. Of its roots the one is
/// taken at which the gap closes.
///
/// A sphere that touches now gives 0 if it comes closer, or stands still and is pulled. One that
/// rises from the plane, or from a little behind it, gives the time at which it is back; if it
/// does not get clear, the time at which it stops rising. One that lies on the plane without a pull
/// gives nothing.
/// @param sphere at t = 0, m, finite, with a radius that is not negative
/// @param velocity at t = 0, m/s, finite
/// @param gravity constant acceleration, m/s², finite; 0 is allowed
/// @param plane with a unit normal; its back is full
/// @return s; nothing if it never arrives, or later than the largest number. Off by at most 8 u of
/// itself for times from 2^-500 s to 2^500 s in double (2^-60 s to 2^60 s in float)
template <std::floating_point S>
std::optional<S> ballistic_sphere_plane(const Sphere<S>& sphere, const Vector3<S>& velocity,
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
