/// @file
/// The kinematic response: the velocity after a bounce, with and without friction, and the
/// measurement of the coefficient of restitution.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <concepts>
#include <utility>

#include <contact/collision_1d.hpp>
#include <contact/exact.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact {

// [approaches]
/// Whether a body with this velocity moves against the normal, v · n < 0: towards the surface. Only
/// then does it bounce.
///
/// The answer is exact for the stored numbers: where rounding could change the sign, it is computed
/// in exact arithmetic (a floating-point filter).
/// @param velocity m/s, relative to the surface
/// @param normal points away from the surface; any length but 0
/// @return false for a velocity along the surface, or of 0
/// @see *Game Physics – Part III: Collisions*, slide "Normal Velocity Equations"
template <Ring S>
bool approaches(const Vector3<S>& velocity, const Vector3<S>& normal) {
  const S sum = velocity.dot(normal);
  if constexpr (std::floating_point<S>) {
    const S size = velocity.cwiseAbs().dot(normal.cwiseAbs());
    // Three products and two sums are off by less than γ(3) of the magnitude, plus an underflow
    // each.
    const S bound = S(4) * tolerance::unit_roundoff<S> * size + S(4) * tolerance::underflow_unit<S>;
    if (sum > bound) return false;
    if (sum < -bound) return true;
    Exact exact;
    for (int i = 0; i < 3; ++i) exact += Exact(double(velocity(i))) * Exact(double(normal(i)));
    return exact.sign() < 0;
  } else {
    return sum < S(0);
  }
}
// [/approaches]

/// The velocity after a bounce without friction, v' = v − (1 + k)(v · N) N: the normal component is
/// multiplied by −k, the tangential component is unchanged.
/// @param velocity before, m/s, relative to the surface
/// @param normal unit vector, points away from the surface
/// @param k coefficient of restitution, 0 to 1
/// @return m/s; the velocity unchanged unless it approaches() the surface. Each entry off by at
/// most 24 u |v|
/// @see *Interaction and Normals*, slides "Collision response: kinematic" and "Collision reaction"
// [after-bounce]
template <Scalar S>
Vector3<S> after_bounce(const Vector3<S>& velocity, const Vector3<S>& normal, const S& k) {
  if (!approaches(velocity, normal)) return velocity;
  const S along_normal = velocity.dot(normal);
  return velocity - normal * ((S(1) + k) * along_normal);
}
// [/after-bounce]

namespace detail {

/// A vector scaled by a power of two to a largest entry in [1/2, 1), and the power.
template <std::floating_point S>
std::pair<Vector3<S>, int> to_unit_range(const Vector3<S>& v) {
  int power = 0;
  std::frexp(v.cwiseAbs().maxCoeff(), &power);
  return {v.unaryExpr([power](S x) { return S(std::ldexp(x, -power)); }), power};
}

template <Scalar S>
Vector3<S> bounce_off(const Vector3<S>& v, const Vector3<S>& d, const S& k) {
  return v - d * ((S(1) + k) * v.dot(d) / d.dot(d));
}

}  // namespace detail

// [after-bounce-along]
/// The same for a normal of any length, such as a cross product of two edges, without a square
/// root: v' = v − (1 + k) (v · d) / (d · d) d. So it is rational, and exact if S is.
/// @param velocity before, m/s, relative to the surface
/// @param direction points away from the surface; any length but 0
/// @param k coefficient of restitution, 0 to 1
/// @return m/s; the velocity unchanged unless it approaches() the surface, or if the direction is
/// 0. Each entry off by at most 24 u |v|, whatever the magnitudes of velocity and direction
template <Scalar S>
Vector3<S> after_bounce_along(const Vector3<S>& velocity, const Vector3<S>& direction, const S& k) {
  if (!approaches(velocity, direction)) return velocity;
  if constexpr (std::floating_point<S>) {
    const auto [v, power] = detail::to_unit_range(velocity);
    const auto [d, ignored] = detail::to_unit_range(direction);
    const int up = power;
    return detail::bounce_off<S>(v, d, k).unaryExpr([up](S x) { return S(std::ldexp(x, up)); });
  } else {
    return detail::bounce_off<S>(velocity, direction, k);
  }
}
// [/after-bounce-along]

/// The share of its tangential velocity that a solid ball without rotation loses until it rolls:
/// 2/7.
template <Scalar S>
inline const S solid_ball_grip = S(2) / S(7);

/// The velocity after a bounce with Coulomb friction.
///
/// The normal velocity changes by (1 + k)|v · N|. Friction changes the tangential velocity by up to
/// μ times as much, against it, and no more than `grip` times the tangential velocity.
/// @param velocity before, m/s, of the centre, relative to the surface
/// @param normal unit vector, points away from the surface
/// @param k coefficient of restitution, 0 to 1
/// @param friction coefficient μ, 0 or more
/// @param grip share of the tangential velocity that friction can take: 1 for a body that does not
/// rotate, solid_ball_grip for a solid ball that arrives without rotation, where the slip then
/// stops. With a tangential restitution e_t, 1 + e_t times as much: the slip is reversed, as on a
/// superball
/// @return m/s; the velocity unchanged unless it approaches() the surface. Each entry off by at
/// most 60 (1 + μ) u |v|, for speeds from 1e-150 to 1e150 m/s (in double)
/// @note A model. If the centre of mass is not above the contact, this rule can gain energy.
// [after-bounce-with-friction]
template <std::floating_point S>
Vector3<S> after_bounce_with_friction(const Vector3<S>& velocity, const Vector3<S>& normal,
                                      const S& k, const S& friction, const S& grip = S(1)) {
  if (!approaches(velocity, normal)) return velocity;
  const S along_normal = velocity.dot(normal);
  const Vector3<S> tangent = velocity - normal * along_normal;
  const S slip = tangent.norm();
  const S normal_change = -(S(1) + k) * along_normal;
  const S friction_change = std::min(friction * normal_change, grip * slip);
  const S kept = slip > S(0) ? S(S(1) - friction_change / slip) : S(1);
  return tangent * kept - normal * (k * along_normal);
}
// [/after-bounce-with-friction]

// [measured]
/// The coefficient of restitution: the separation speed over the approach speed, both along the
/// normal.
/// @param approach m/s, greater than 0
/// @param separation m/s, 0 or more
/// @throws std::invalid_argument if approach is not greater than 0, separation is negative, or one
/// is not finite
template <Scalar S>
S restitution_from_speeds(const S& approach, const S& separation) {
  require_finite("approach", approach);
  require_finite("separation", separation);
  if (!(approach > S(0))) {
    throw_invalid_argument("approach", number_text(approach), "must be greater than 0");
  }
  if (separation < S(0)) {
    throw_invalid_argument("separation", number_text(separation), "must not be negative");
  }
  return separation / approach;
}

/// The coefficient of restitution from a drop: k = √(rebound / drop), since the height goes with
/// the square of the speed at the floor.
/// @param drop height of the drop, m, greater than 0
/// @param rebound height of the rebound, m, 0 or more
/// @return off by at most 3 u of itself, also where the quotient would underflow or overflow; ∞
/// only if the root is beyond the largest number. More than 1 for a rebound above the drop: then
/// the ball was thrown, or energy was added
/// @throws std::invalid_argument if drop is not greater than 0, rebound is negative, or one is not
/// finite
template <std::floating_point S>
S restitution_from_heights(const S& drop, const S& rebound) {
  require_finite("drop", drop);
  require_finite("rebound", rebound);
  if (!(drop > S(0))) throw_invalid_argument("drop", number_text(drop), "must be greater than 0");
  if (rebound < S(0)) {
    throw_invalid_argument("rebound", number_text(rebound), "must not be negative");
  }
  if (rebound == S(0)) return S(0);
  int drop_power = 0;
  int rebound_power = 0;
  const S above = std::frexp(rebound, &rebound_power);
  const S below = std::frexp(drop, &drop_power);
  int power = rebound_power - drop_power;
  S ratio = above / below;
  if (power % 2 != 0) {  // a root needs an even power
    ratio *= S(2);
    --power;
  }
  return std::ldexp(std::sqrt(ratio), power / 2);
}
// [/measured]

}  // namespace contact
