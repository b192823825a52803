/// @file
/// Pieces that fly apart: a body that breaks in two, and the energy released.
#pragma once

#include <cmath>
#include <concepts>

#include <contact/collision_1d.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/momentum.hpp>
#include <contact/vector.hpp>

namespace contact {

/// A body that breaks into two pieces and releases a given energy.
///
/// The velocity of the centre of mass is conserved, so the energy released is that of the relative
/// velocity u of the pieces: Q = ½ μ u², with the reduced mass μ = m₁ m₂/(m₁ + m₂).
/// @param first_mass, second_mass kg, greater than 0
/// @param together velocity of the whole, m/s
/// @param energy Q, J, not negative
/// @param direction of the second piece's velocity relative to the first, of any length but zero
/// @throws std::invalid_argument if a mass is not greater than 0, the energy is negative, the
/// direction is zero, or a number is not finite
/// @return as push_off(): off by a few u of |v| + |u|, as long as Q/μ and the squares of the
/// direction neither overflow nor underflow
/// @see *Interaction and Normals*, the alpha decay, which the slides count as an elastic collision
template <std::floating_point S>
PushOff<S> fly_apart(const S& first_mass, const S& second_mass, const Vector3<S>& together,
                     const S& energy, const Vector3<S>& direction) {
  require_mass("first_mass", first_mass);
  require_mass("second_mass", second_mass);
  require_finite("together", together);
  require_finite("energy", energy);
  if (energy < S(0)) throw_invalid_argument("energy", number_text(energy), "must not be negative");
  require_finite("direction", direction);
  const S length = std::sqrt(direction.dot(direction));
  if (!(length > S(0))) {
    throw_invalid_argument("direction", vector_text(direction), "must have a length");
  }
  const S speed = std::sqrt(S(2) * energy / reduced_mass(first_mass, second_mass));
  return push_off<S>(first_mass, second_mass, together, Vector3<S>(direction * S(speed / length)));
}

/// The energy of the relative motion of two pieces, ½ μ |u|²: released when they fly apart, lost
/// when they stick together.
/// @param first_mass, second_mass kg, greater than 0
/// @param relative velocity of one relative to the other, m/s
/// @return J, not negative, off by at most 10 u of itself if nothing overflows or underflows
template <Scalar S>
S energy_apart(const S& first_mass, const S& second_mass, const Vector3<S>& relative) {
  return reduced_mass(first_mass, second_mass) * relative.dot(relative) / S(2);
}

}  // namespace contact
