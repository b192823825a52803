/// @file
/// Penalty forces on balls: from a half-space, and between two balls.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>

#include <contact/exact.hpp>
#include <contact/shapes.hpp>
#include <contact/spring_damper.hpp>
#include <contact/tolerance.hpp>
#include <contact/vector.hpp>

namespace contact {

/// Position, radius and velocity of a ball.
template <Ring S>
struct PenaltyBall {
  Sphere<S> sphere;                          ///< m
  Vector3<S> velocity = Vector3<S>::Zero();  ///< of its centre, m/s
};

/// A contact with its force.
template <Ring S>
struct PenaltyForce {
  bool touching = false;                  ///< whether there is a contact; touching counts
  S penetration = S(0);                   ///< m, 0 without contact
  Vector3<S> force = Vector3<S>::Zero();  ///< on the first ball, N; the opposite acts on the other
};

// [half-space-overlap]
/// Whether a ball overlaps a half-space: the sign of r − (n · c − k), negative for a gap, 0 for
/// touching.
/// @param plane with a unit normal, which points out of the half-space
/// @return −1, 0 or 1, exact for the stored numbers: where rounding could change the sign, it is
/// computed again without rounding; −1 if a number is not finite
template <Ring S>
int overlap_sign(const Sphere<S>& ball, const Plane<S>& plane) {
  const S value = ball.radius - (plane.normal.dot(ball.centre) - plane.offset);
  if constexpr (std::floating_point<S>) {
    const S size =
        ball.radius + plane.normal.cwiseAbs().dot(ball.centre.cwiseAbs()) + std::abs(plane.offset);
    // Each term is rounded at most five times; each product that underflows loses η.
    const S bound = S(8) * tolerance::unit_roundoff<S> * size + S(8) * tolerance::underflow_unit<S>;
    if (value > bound) return 1;
    if (value < -bound) return -1;
    if (!plane.normal.allFinite() || !ball.centre.allFinite() || !std::isfinite(plane.offset) ||
        !std::isfinite(ball.radius)) {
      return -1;
    }
    Exact exact = Exact(double(ball.radius)) + Exact(double(plane.offset));
    for (int i = 0; i < 3; ++i) {
      exact -= Exact(double(plane.normal(i))) * Exact(double(ball.centre(i)));
    }
    return exact.sign();
  } else {
    return value > S(0) ? 1 : (value < S(0) ? -1 : 0);
  }
}
// [/half-space-overlap]

// [half-space-force]
/// The penalty force of a half-space on a ball: contact_force() along the plane's normal, with the
/// penetration r − (n · c − k).
/// @param plane with a unit normal, which points out of the half-space
/// @return no force without contact, or if a position is not finite; whether they touch is decided
/// exactly, and the error of the penetration is at most 8 u (r + Σ |nᵢ cᵢ| + |k|), without
/// underflow: far from the origin n · c loses digits
template <Ring S>
PenaltyForce<S> half_space_force(const PenaltyBall<S>& ball, const Plane<S>& plane,
                                 const SpringDamper<S>& spring,
                                 ContactRelease rule = ContactRelease::at_zero_force) {
  if (overlap_sign(ball.sphere, plane) < 0) return {};
  const S distance = plane.normal.dot(ball.sphere.centre) - plane.offset;
  const S penetration = std::max(S(0), S(ball.sphere.radius - distance));
  const S approach = -plane.normal.dot(ball.velocity);
  const S force = contact_force(spring, penetration, approach, rule);
  return {true, penetration, plane.normal * force};
}
// [/half-space-force]

// [balls-overlap]
/// Whether two balls overlap: the sign of (r₁ + r₂)² − |c₁ − c₂|², negative for a gap, 0 for
/// touching.
/// @return −1, 0 or 1, exact for the stored numbers: where rounding could change the sign, it is
/// computed again without rounding; −1 if a number is not finite
template <Ring S>
int overlap_sign(const Sphere<S>& first, const Sphere<S>& second) {
  if constexpr (std::floating_point<S>) {
    const Vector3<S> apart = first.centre - second.centre;
    const S radius_sum = first.radius + second.radius;
    const S square = apart.dot(apart);
    const S value = radius_sum * radius_sum - square;
    // Each term is rounded at most five times; each square that underflows loses η.
    const S bound = S(16) * tolerance::unit_roundoff<S> * (radius_sum * radius_sum + square) +
                    S(8) * tolerance::underflow_unit<S>;
    if (value > bound) return 1;
    if (value < -bound) return -1;
    if (!first.centre.allFinite() || !second.centre.allFinite() || !std::isfinite(first.radius) ||
        !std::isfinite(second.radius)) {
      return -1;
    }
    const Exact sum = Exact(double(first.radius)) + Exact(double(second.radius));
    Exact exact = sum * sum;
    for (int i = 0; i < 3; ++i) {
      const Exact d = Exact(double(first.centre(i))) - Exact(double(second.centre(i)));
      exact -= d * d;
    }
    return exact.sign();
  } else {
    const Vector3<S> apart = first.centre - second.centre;
    const S radius_sum = first.radius + second.radius;
    const S value = radius_sum * radius_sum - apart.dot(apart);
    return value > S(0) ? 1 : (value < S(0) ? -1 : 0);
  }
}
// [/balls-overlap]

// [ball-ball-force]
/// The penalty force of the second ball on the first, along the line of centres, from the second to
/// the first. The force on the second is exactly the opposite, so the momentum is conserved.
///
/// Whether they touch is decided exactly. Concentric balls have no line of centres: they touch, the
/// penetration is r₁ + r₂, and there is no force.
/// @param spring of the pair
/// @return no force without contact, or if a position is not finite; the error of the penetration
/// is at most 8 u (r₁ + r₂) plus the rounding of the difference of the centres, and it is not
/// negative; r₁ + r₂ and the difference of the centres must not overflow
template <std::floating_point S>
PenaltyForce<S> ball_ball_force(const PenaltyBall<S>& first, const PenaltyBall<S>& second,
                                const SpringDamper<S>& spring,
                                ContactRelease rule = ContactRelease::at_zero_force) {
  if (overlap_sign(first.sphere, second.sphere) < 0) return {};
  const Vector3<S> apart = first.sphere.centre - second.sphere.centre;
  const S radius_sum = first.sphere.radius + second.sphere.radius;
  const S scale = apart.cwiseAbs().maxCoeff();
  if (!(scale > S(0))) return {true, radius_sum, Vector3<S>::Zero()};
  const Vector3<S> shrunk = apart / scale;
  const S length = std::sqrt(shrunk.dot(shrunk));
  const Vector3<S> normal = shrunk / length;
  const S penetration = std::max(S(0), S(radius_sum - scale * length));
  const S approach = -normal.dot(Vector3<S>(first.velocity - second.velocity));
  return {true, penetration, normal * contact_force(spring, penetration, approach, rule)};
}
// [/ball-ball-force]

}  // namespace contact
