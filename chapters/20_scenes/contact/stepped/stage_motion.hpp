/// @file
/// Stages of motion: gravity; the motion of every mover, exact for a free flight; rotation with
/// constant angular velocity, or with the gyroscopic term; removal of overlaps that rotation and
/// residuals of the iterations have left. And bounds for torque-free rotation: the largest angular
/// velocity, and the substeps.
#pragma once

#include <cstddef>

#include <contact/contact_manifold.hpp>
#include <contact/inertia.hpp>
#include <contact/quaternion.hpp>
#include <contact/rotation.hpp>
#include <contact/signed_distance.hpp>
#include <contact/stepped/stepped_state.hpp>
#include <contact/vector.hpp>

namespace contact {

/// The largest angle by which a body rotates between two evaluations of its angular velocity: 2^-7
/// rad. The rotation of a free body is then wrong by less than 2^-28/120 of itself: the fifth-order
/// term of an exponential.
inline constexpr double gyroscopic_angle = 0x1p-7;

/// The square of the largest angular velocity that a body reaches without torque, rad²/s². Its
/// energy bounds that, Σ I ω² ≤ 2 E; so do its energy and angular momentum together: with the
/// moments I₁ ≤ I₂ ≤ I₃, what 2 E I₃ − L² leaves for the axis of I₁, and 2 E for the others. A
/// needle that rotates about an axis perpendicular to it never comes to rotate about its own axis.
/// @param moments about its principal axes, kg·m²
/// @param angular_velocity angular velocity along these axes, rad/s
double largest_free_square(const Vector3<double>& moments, const Vector3<double>& angular_velocity);

// [gravity-stage]
/// Gravity changes each mover's velocity at the end of the substep.
inline void add_gravity(const SteppedSetup& setup, SteppedState& state, Substep& substep) {
  const Vector3<double> change = setup.scene.gravity * substep.planned;
  for (std::size_t i = 0; i < setup.movers; ++i) {
    if (!sleeps(state, i)) substep.end_velocity.add(i, change);
  }
}
// [/gravity-stage]

/// Every mover moves on to the end of the substep, with constant acceleration.
void move_bodies(const SteppedSetup& setup, SteppedState& state, Substep& substep);

namespace detail {

/// Rotation of a mover through a substep: at the mean of its angular velocities at both ends.
inline Vector3<double> mean_angular_velocity(const SteppedState& state, const Substep& substep,
                                             std::size_t i, double length) {
  if (substep.at_start[i]) return substep.end_angular_velocity[i];
  const Vector3<double> change = substep.end_angular_velocity[i] - state.angular_velocity[i];
  return state.angular_velocity[i] + change * (length / substep.planned / 2);
}

/// The angular velocity at the end of a substep of this length, by contact forces alone.
inline Vector3<double> contact_angular_velocity(const SteppedState& state, const Substep& substep,
                                                std::size_t i, double length) {
  if (substep.at_start[i] || length == substep.planned) return substep.end_angular_velocity[i];
  const Vector3<double> change = substep.end_angular_velocity[i] - state.angular_velocity[i];
  return state.angular_velocity[i] + change * (length / substep.planned);
}

/// Orientation of a mover after a substep of this length, at constant angular velocity.
inline Quaternion<double> rotated_uniformly(const SteppedState& state, const Substep& substep,
                                            std::size_t i, double length) {
  return normalised(exponential_step(state.orientation[i],
                                     mean_angular_velocity(state, substep, i, length), length));
}

}  // namespace detail

/// Every mover rotates at constant angular velocity. That is exact without torque for a body whose
/// moments of inertia are equal, or that rotates about a principal axis.
void rotate_bodies(const SteppedSetup& setup, SteppedState& state, Substep& substep);

namespace detail {

/// The angular momentum of a body with this orientation and angular velocity, in the world,
/// kg·m²/s.
inline Vector3<double> angular_momentum_of(const SteppedBody& body, const Quaternion<double>& q,
                                           const Vector3<double>& angular_velocity) {
  const Matrix3<double> principal = matrix_of(q) * body.axes;
  const Vector3<double> seen = principal.transpose() * angular_velocity;
  return principal * Vector3<double>(seen.cwiseProduct(body.moments));
}

/// largest_free_square() of a body with this orientation and angular velocity, in the world,
/// rad²/s².
inline double largest_free_square(const SteppedBody& body, const Quaternion<double>& q,
                                  const Vector3<double>& angular_velocity) {
  const Vector3<double> seen = (matrix_of(q) * body.axes).transpose() * angular_velocity;
  return contact::largest_free_square(body.moments, seen);
}

/// Orientation of a mover after a substep of this length: while contacts push, it rotates as with
/// the mean of its angular momenta.
Quaternion<double> rotated_freely(const SteppedSetup& setup, const SteppedState& state,
                                  const Substep& substep, std::size_t i, double length);

}  // namespace detail

/// Rotation with the gyroscopic term: contacts change the angular momentum, and the angular
/// velocity follows from it and the orientation.
void rotate_with_gyroscopic_term(const SteppedSetup& setup, SteppedState& state, Substep& substep);

/// The number of passes over the overlaps; each removes half of the remaining overlap.
inline constexpr int position_iterations = 8;

/// Removes overlaps of hard bodies, by moving the two of each apart along their normal, the lighter
/// one farther. A body that is lifted against gravity by this pays with its kinetic energy, and one
/// that is lowered gains as much, unless its kinetic energy is smaller than that.
///
/// Rotation causes such overlaps, because contacts hold the points where bodies touch, and these
/// move. So do residuals of the iterations.
void correct_positions(const SteppedSetup& setup, SteppedState& state, Substep& substep);

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/stage_motion.cpp"
#endif
