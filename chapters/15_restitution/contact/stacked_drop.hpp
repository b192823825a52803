/// @file
/// Two balls dropped together, one above the other: the lower one bounces off the floor, the upper
/// one off the lower.
#pragma once

#include <contact/momentum.hpp>
#include <contact/restitution.hpp>
#include <contact/vector.hpp>

namespace contact {

/// Velocities upwards, m/s.
template <Scalar S>
struct StackedDrop {
  S lower_from_floor = S(0);  ///< of the lower ball between its two collisions
  S lower = S(0);             ///< of the lower ball after both
  S upper = S(0);             ///< of the upper ball after both
};

// [stacked-drop]
/// Two balls fall together, one just above the other, and reach the floor. First the lower one
/// bounces off the floor, then the two collide.
///
/// In the second collision the common velocity is that of the centre of mass, as if they stuck
/// together; from it they push off with k times their approach speed.
/// @param lower_mass, upper_mass kg, finite and greater than 0
/// @param speed of both downwards, m/s, 0 or more
/// @param floor coefficient of restitution of lower ball and floor, 0 to 1
/// @param balls coefficient of restitution of the two balls, 0 to 1
/// @return the state before any further impact: a lower velocity below 0 means that the lower ball
/// goes down to the floor again. Off by a few u of the speed
/// @note If the balls touched when the lower one reached the floor, the two collisions would be
/// simultaneous, and the answer would depend on the stiffness of each contact.
/// @throws std::invalid_argument if a mass or a coefficient is out of range
template <Scalar S>
StackedDrop<S> drop_stacked(const S& lower_mass, const S& upper_mass, const S& speed,
                            const S& floor, const S& balls) {
  require_restitution("floor", floor);
  require_restitution("balls", balls);
  const Vector3<S> up(S(0), S(0), S(1));
  const Vector3<S> down = up * S(-speed);
  const auto lower = point_mass<S>(lower_mass, up * S(0), after_bounce<S>(down, up, floor));
  const auto upper = point_mass<S>(upper_mass, up * S(0), down);
  const S closing = lower.velocity.z() - upper.velocity.z();
  const Vector3<S> together = *centre_velocity<S>({lower, upper});
  const auto after = push_off<S>(lower_mass, upper_mass, together, up * S(balls * closing));
  return {lower.velocity.z(), after.first.z(), after.second.z()};
}
// [/stacked-drop]

}  // namespace contact
