/// @file
/// Collisions of two bodies on a line: the velocities afterwards, the impulse between them, and the
/// loss of kinetic energy.
///
/// The first body is the one with the smaller coordinate, and velocities are positive in the
/// direction from the first to the second. So they approach if v₁ > v₂.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <concepts>
#include <initializer_list>
#include <limits>
#include <optional>

#include <contact/exact.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/vector.hpp>

namespace contact {

/// A body on a line. Make it with line_body(), which checks its arguments.
template <Ring S>
struct LineBody {
  S mass = S(1);      ///< kg, greater than 0; infinite for a wall, whose velocity never changes
  S velocity = S(0);  ///< m/s
};

/// A body on a line with a mass and a velocity.
/// @param mass kg, greater than 0; infinity makes a wall, at rest or moving
/// @param velocity m/s
/// @throws std::invalid_argument if the mass is not greater than 0 or the velocity is not finite
template <Ring S>
LineBody<S> line_body(const S& mass, const S& velocity) {
  if (!(mass > S(0))) {
    throw_invalid_argument("mass", number_text(mass), "a mass must be greater than 0");
  }
  require_finite("velocity", velocity);
  return {mass, velocity};
}

/// Throws std::invalid_argument unless a coefficient of restitution is from 0 to 1.
template <Ring S>
void require_restitution(const char* argument, const S& e) {
  if (!(e >= S(0) && e <= S(1))) {
    throw_invalid_argument(argument, number_text(e),
                           "a coefficient of restitution must be from 0 to 1");
  }
}

// [approaching]
/// Whether two bodies approach, so that they collide when they touch. With equal velocities they do
/// not.
///
/// A comparison of stored numbers is exact, even if the difference of the velocities would round or
/// overflow.
template <Ring S>
bool approaching(const LineBody<S>& first, const LineBody<S>& second) {
  return first.velocity > second.velocity;
}

/// The closing speed, v₁ − v₂; negative if the bodies separate. After a collision its opposite is
/// the speed of separation.
/// @return m/s, with an error of at most u of itself; ±∞ only if the true difference is beyond the
/// largest number
/// @see *Interaction and Normals*, slide "Elastic Collisions in 1-dimension": "relative velocity of
/// approach"
template <Ring S>
S closing_speed(const LineBody<S>& first, const LineBody<S>& second) {
  return first.velocity - second.velocity;
}
// [/approaching]

/// The shares of two bodies in their total mass.
template <Ring S>
struct MassShares {
  S first = S(0);   ///< m₁ / (m₁ + m₂)
  S second = S(0);  ///< m₂ / (m₁ + m₂)
};

// [mass-shares]
/// The share of each body in the total mass. A body's part of a change of relative velocity is the
/// *other* body's share: the lighter body changes its velocity more.
/// @param first_mass, second_mass kg, greater than 0; an infinite one has the share 1, and two
/// infinite ones have one half each
/// @return each with an error of at most γ(2) of itself, if it does not underflow. No sum overflows
template <Scalar S>
MassShares<S> mass_shares(const S& first_mass, const S& second_mass) {
  if constexpr (std::floating_point<S>) {
    const bool wall_1 = std::isinf(first_mass);
    const bool wall_2 = std::isinf(second_mass);
    if (wall_1 && wall_2) return {S(0.5), S(0.5)};
    if (wall_1 || wall_2) return {S(wall_1 ? 1 : 0), S(wall_2 ? 1 : 0)};
    if (!std::isfinite(first_mass + second_mass)) {
      const S half_sum = first_mass / S(2) + second_mass / S(2);
      return {first_mass / S(2) / half_sum, second_mass / S(2) / half_sum};
    }
  }
  const S sum = first_mass + second_mass;
  return {first_mass / sum, second_mass / sum};
}

/// The reduced mass μ = m₁ m₂ / (m₁ + m₂). It is less than either mass, and at least half the
/// smaller one.
/// @param first_mass, second_mass kg, greater than 0; with a wall it is the other body's mass
/// @return kg, with an error of at most γ(3) of itself, if it does not underflow; ∞ only for two
/// infinite masses
template <Scalar S>
S reduced_mass(const S& first_mass, const S& second_mass) {
  const MassShares<S> share = mass_shares(first_mass, second_mass);
  // The smaller mass times a share of at least a half: nothing here overflows.
  return first_mass < second_mass ? S(first_mass * share.second) : S(second_mass * share.first);
}
// [/mass-shares]

/// The outcome of a collision.
template <Ring S>
struct LineCollision {
  /// Whether they collided: they approached, and at least one of them was no wall.
  bool collided = false;
  S first = S(0);   ///< velocity of the first afterwards, m/s
  S second = S(0);  ///< velocity of the second afterwards, m/s
};

namespace detail {

template <Ring S>
bool can_be_reversed(const LineBody<S>& body) {
  if constexpr (std::floating_point<S>) {
    return std::isfinite(body.mass);
  } else {
    return true;
  }
}

template <Ring S>
bool collides(const LineBody<S>& first, const LineBody<S>& second) {
  return approaching(first, second) && (can_be_reversed(first) || can_be_reversed(second));
}

// [rebound]
/// The velocities after a collision, for v₁ > v₂ whose difference does not overflow.
template <Scalar S>
LineCollision<S> rebound(const MassShares<S>& share, const S& v1, const S& v2, const S& e) {
  if (e == S(0)) {
    // Both get the velocity of the centre of mass.
    const S together = std::clamp(S(share.first * v1 + share.second * v2), v2, v1);
    return {true, together, together};
  }
  const S w = v1 - v2;
  // The heavier body changes its own velocity a little. The lighter (or equal) one starts from the
  // other's velocity and changes that, so equal bodies exchange velocities bit for bit.
  S first = share.first > share.second ? S(v1 - (S(1) + e) * share.second * w)
                                       : S(v2 + (share.first - e * share.second) * w);
  S second = share.second > share.first ? S(v2 + (S(1) + e) * share.first * w)
                                        : S(v1 - (share.second - e * share.first) * w);
  if (first > second) {
    // The speed of separation is below the rounding error: make it 0, so that they do not approach.
    if (share.first > share.second) {
      second = first;
    } else if (share.second > share.first) {
      first = second;
    } else {
      first = second = first / S(2) + second / S(2);
    }
  }
  return {true, first, second};
}
// [/rebound]

/// The product of finite factors times 2^exponent, without intermediate overflow or underflow.
template <std::floating_point S>
S scaled_product(std::initializer_list<S> factors, int exponent) {
  S mantissa(1);
  for (const S factor : factors) {
    int power = 0;
    mantissa *= std::frexp(factor, &power);
    exponent += power;
  }
  return std::ldexp(mantissa, exponent);
}

/// v₁ − v₂ as value × 2^exponent, which does not overflow.
template <std::floating_point S>
struct Difference {
  S value;
  int exponent;
};
template <std::floating_point S>
Difference<S> difference(const S& v1, const S& v2) {
  if (std::isfinite(v1 - v2)) return {v1 - v2, 0};
  return {v1 / S(2) - v2 / S(2), 1};
}

}  // namespace detail

// [collide]
/// The velocities of two bodies after they have collided.
///
/// Momentum is conserved, and the speed of separation is e times the closing speed w = v₁ − v₂:
/// v₁' = v₁ − (1 + e) w m₂/(m₁ + m₂) and v₂' = v₂ + (1 + e) w m₁/(m₁ + m₂). For e = 1 the collision
/// is elastic and no kinetic energy is lost; for e = 0 it is perfectly inelastic and both leave
/// with one velocity. Bodies that do not approach do not collide and keep their velocities.
/// @param first, second of line_body(), in the order of their coordinates. Two walls keep their
/// velocities
/// @param e coefficient of restitution, from 0 to 1
/// @return in a floating-point type the error of each velocity is at most γ(8) (|v₁| + |v₂|) + η. A
/// small velocity may have no right digit: it changes by as much if the input changes by an ulp.
/// Finite unless the true velocity is beyond the largest number; never NaN
/// @note Properties that rounding does not affect: the bodies do not approach afterwards; for e = 0
/// both velocities are the same number; in an elastic collision equal bodies exchange velocities
/// exactly; a wall keeps its velocity exactly; the mirrored collision (masses exchanged, velocities
/// exchanged and negated) has the mirrored result
/// @see *Interaction and Normals*, slides "Elastic Collisions in 1-dimension" and "Perfectly
/// Inelastic Collisions"; *Fundamentals of Computer Animation*, "Collisions Between Spheres", step
/// c
template <Scalar S>
LineCollision<S> collide(const LineBody<S>& first, const LineBody<S>& second, const S& e) {
  assert(e >= S(0) && e <= S(1));
  const S& v1 = first.velocity;
  const S& v2 = second.velocity;
  if (!detail::collides(first, second)) return {false, v1, v2};
  const MassShares<S> share = mass_shares(first.mass, second.mass);
  if constexpr (std::floating_point<S>) {
    if (!std::isfinite(v1 - v2)) {
      LineCollision<S> after = detail::rebound<S>(share, v1 / S(8), v2 / S(8), e);
      after.first *= S(8);
      after.second *= S(8);
      return after;
    }
  }
  return detail::rebound(share, v1, v2, e);
}
// [/collide]

// [impulse]
/// The impulse of the first body on the second, (1 + e) μ w; that on the first is the opposite. It
/// is never negative, since bodies push and do not pull; 0 if they do not collide.
/// @param first, second, e as for collide()
/// @return N·s, with an error of at most γ(7) of itself, if it does not underflow; ∞ only if the
/// true impulse is about as large as the largest number
template <Scalar S>
S collision_impulse(const LineBody<S>& first, const LineBody<S>& second, const S& e) {
  if (!detail::collides(first, second)) return S(0);
  const S mu = reduced_mass(first.mass, second.mass);
  if constexpr (std::floating_point<S>) {
    const auto w = detail::difference(first.velocity, second.velocity);
    return detail::scaled_product({mu, S(1) + e, w.value}, w.exponent);
  } else {
    return (S(1) + e) * mu * (first.velocity - second.velocity);
  }
}
// [/impulse]

// [energy-lost]
/// The kinetic energy that a collision loses, ½ μ (1 − e²) w².
///
/// It depends on the velocities only through the closing speed w, so it is the same in every frame,
/// although the kinetic energies differ. It is computed as a product, which has no cancellation;
/// the difference of the energies before and after has.
/// @param first, second, e as for collide(); with a moving wall it is the loss in the wall's frame
/// @return J, never negative, with an error of at most γ(11) of itself, if it does not underflow; 0
/// if they do not collide; ∞ only if the true loss is about as large as the largest number
template <Scalar S>
S energy_lost(const LineBody<S>& first, const LineBody<S>& second, const S& e) {
  if (!detail::collides(first, second)) return S(0);
  const S mu = reduced_mass(first.mass, second.mass);
  if constexpr (std::floating_point<S>) {
    const auto w = detail::difference(first.velocity, second.velocity);
    return detail::scaled_product({mu, S(1) - e, S(1) + e, w.value, w.value}, 2 * w.exponent - 1);
  } else {
    const S w = first.velocity - second.velocity;
    return mu * (S(1) - e) * (S(1) + e) * w * w / S(2);
  }
}
// [/energy-lost]

/// The kinetic energy of a body, ½ m v².
/// @return J, with an error of at most γ(2) of itself, if it does not underflow; ∞ if the true
/// energy is beyond the largest number, and for a moving wall
template <Scalar S>
S kinetic_energy(const LineBody<S>& body) {
  if (body.velocity == S(0)) return S(0);
  if constexpr (std::floating_point<S>) {
    if (std::isinf(body.mass)) return body.mass;
    return detail::scaled_product({body.mass, body.velocity, body.velocity}, -1);
  } else {
    return body.mass * body.velocity * body.velocity / S(2);
  }
}

// [restitution]
/// The coefficient of restitution of a collision that was measured: the speed of separation over
/// the closing speed.
///
/// Below 0 the bodies have passed through each other; at 0 they left with one velocity (but need
/// not adhere); at 1 no kinetic energy was lost; above 1 some was released.
/// @param first, second of line_body(), before
/// @param first_after, second_after velocities, m/s
/// @return in a floating-point type with an error of at most γ(3) of itself, if nothing underflows;
/// nothing if they did not approach, because then there was no collision
template <Scalar S>
std::optional<S> restitution_of(const LineBody<S>& first, const LineBody<S>& second,
                                const S& first_after, const S& second_after) {
  if (!approaching(first, second)) return std::nullopt;
  if constexpr (std::floating_point<S>) {
    const auto parting = detail::difference(second_after, first_after);
    const auto closing = detail::difference(first.velocity, second.velocity);
    return std::ldexp(parting.value / closing.value, parting.exponent - closing.exponent);
  } else {
    return (second_after - first_after) / (first.velocity - second.velocity);
  }
}
// [/restitution]

// [collide-exactly]
/// The exact velocities after a collision of the stored masses, velocities and e, each rounded once
/// to the nearest number.
/// @param first, second, e as for collide()
/// @return ±∞ if the true velocity is beyond the largest number
template <std::floating_point S>
LineCollision<S> collide_exactly(const LineBody<S>& first, const LineBody<S>& second, const S& e) {
  static_assert(std::numeric_limits<S>::digits <= 53, "Exact holds floats and doubles");
  assert(e >= S(0) && e <= S(1));
  if (!detail::collides(first, second)) return {false, first.velocity, second.velocity};
  const bool wall_1 = !detail::can_be_reversed(first);
  const bool wall_2 = !detail::can_be_reversed(second);
  // With a wall the other mass is negligible.
  const Exact m1(wall_1 ? 1.0 : wall_2 ? 0.0 : double(first.mass));
  const Exact m2(wall_2 ? 1.0 : wall_1 ? 0.0 : double(second.mass));
  const Exact v1(double(first.velocity));
  const Exact v2(double(second.velocity));
  const Exact k(double{e});
  const Exact one(1.0);
  const Exact sum = m1 + m2;
  return {true, quotient<S>((m1 - k * m2) * v1 + (one + k) * m2 * v2, sum),
          quotient<S>((m2 - k * m1) * v2 + (one + k) * m1 * v1, sum)};
}
// [/collide-exactly]

}  // namespace contact
