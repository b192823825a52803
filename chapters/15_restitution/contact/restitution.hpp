/// @file
/// The kinematic response: what a bounce does to a velocity, with friction and without, and how the
/// coefficient of restitution is measured.
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
/// Whether something with this velocity moves against the normal, v · n < 0: towards the surface
/// that the normal points away from. Only what approaches bounces.
///
/// The answer is exact for the stored numbers: where rounding could change the sign, it is computed
/// again without rounding.
/// @param velocity m/s, relative to the surface
/// @param normal points away from the surface; any length but 0
/// @return false for a velocity along the surface, or of 0
/// @see *Game Physics – Part III: Collisions*, slide "Normal Velocity Equations"
template <Ring S>
bool approaches(const Vector3<S>& velocity, const Vector3<S>& normal) {
  const S sum = velocity.dot(normal);
  if constexpr (std::floating_point<S>) {
    const S size = velocity.cwiseAbs().dot(normal.cwiseAbs());
    // Three products and two sums are off by less than γ(3) of the size, and by an underflow each.
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

// [after-bounce]
/// The velocity after a bounce without friction, v' = v − (1 + k)(v · N) N: the part along the
/// normal comes back k times as fast, the part along the surface stays.
/// @param velocity before, m/s, relative to the surface
/// @param normal unit vector, points away from the surface
/// @param k coefficient of restitution, 0 to 1
/// @return m/s; the velocity unchanged unless it approaches() the surface. Each entry off by at
/// most 24 u |v|
/// @see *Interaction and Normals*, slides "Collision response: kinematic" and "Collision reaction"
template <Scalar S>
Vector3<S> after_bounce(const Vector3<S>& velocity, const Vector3<S>& normal, const S& k) {
  if (!approaches(velocity, normal)) return velocity;
  const S along_normal = velocity.dot(normal);
  return velocity - normal * ((S(1) + k) * along_normal);
}
// [/after-bounce]

namespace detail {

/// A vector times a power of two, so that its largest entry has a size in [1/2, 1), and the power.
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
/// 0. Each entry off by at most 24 u |v|, whatever the sizes of velocity and direction
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

/// The share of the slip that friction has to take away until a solid ball rolls that came without
/// spin: 2/7. What it takes from the velocity it gives to the spin.
template <Scalar S>
inline const S solid_ball_grip = S(2) / S(7);

// [after-bounce-with-friction]
/// The velocity after a bounce with Coulomb's friction.
///
/// The surface gives the velocity (1 + k)|v · N| along the normal. Friction takes up to μ times as
/// much from the part along the surface, against it, and never turns it round: it ends when the
/// contact no longer slips.
/// @param velocity before, m/s, of the centre, relative to the surface
/// @param normal unit vector, points away from the surface
/// @param k coefficient of restitution, 0 to 1
/// @param friction coefficient μ, 0 or more
/// @param grip how much of the speed along the surface must go until nothing slips: 1 for a body
/// that does not turn, solid_ball_grip for a solid ball that came without spin
/// @return m/s; the velocity unchanged unless it approaches() the surface. Each entry off by at
/// most 60 (1 + μ) u |v|, for speeds from 1e-150 to 1e150 m/s (in double)
/// @note One coefficient for normal and tangent at once is a model. A body whose centre is not over
/// the contact needs more care: there this rule can gain energy.
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
/// The coefficient of restitution from the speeds along the normal: how fast the two part over how
/// fast they met.
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

/// The coefficient of restitution from a drop: k = √(rebound / drop), since a height goes with the
/// square of the speed at the floor.
/// @param drop height from which it was let go, m, greater than 0
/// @param rebound height to which it came back, m, 0 or more
/// @return off by at most 3 u of itself, also where the quotient would underflow or overflow; ∞
/// only if the root is beyond the largest number. More than 1 if it came back higher: then it did
/// not only fall, or something pushed
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
