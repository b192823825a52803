/// @file
/// How fast a body may come to spin that nothing pushes, and how finely such a turn is cut.
/// A stage: gravity.
/// A stage: every mover goes on its way. What nothing touches flies exactly.
/// A stage: every mover turns, with an even spin.
/// A stage: turning with the gyroscopic term, in place of turning with an even spin.
/// A stage: overlaps that turning and unfinished sweeps have left are taken out.
#pragma once

#include <cstddef>

#include <contact/contact_manifold.hpp>
#include <contact/gap.hpp>
#include <contact/inertia.hpp>
#include <contact/rotation.hpp>
#include <contact/stepped/stepped_state.hpp>
#include <contact/vector.hpp>

namespace contact {

/// The largest angle that a body turns by between two looks at its spin: 2^-7 rad. A free body's
/// turn is then off by less than 2^-28/120 of itself: the fifth-order term of an exponential.
inline constexpr double gyroscopic_angle = 0x1p-7;

/// The square of the largest spin that a body comes to by itself, rad²/s². Its energy bounds that,
/// Σ I ω² ≤ 2 E; so do its energy and momentum together: with the moments I₁ ≤ I₂ ≤ I₃, what
/// 2 E I₃ − L² leaves for the axis of I₁, and 2 E for the others. A needle that turns across its
/// axis never comes to turn about it.
/// @param moments about its principal axes, kg·m²
/// @param spin along these axes, rad/s
double largest_free_square(const Vector3<double>& moments, const Vector3<double>& spin);

// [gravity-stage]
/// Gravity changes the velocity that each mover has at the end of the part.
inline void add_gravity(const SteppedSetup& setup, SteppedState& state, StepPart& part) {
  const Vector3<double> change = setup.scene.gravity * part.planned;
  for (std::size_t i = 0; i < setup.movers; ++i) {
    if (!sleeps(state, i)) part.end_velocity.add(i, change);
  }
}
// [/gravity-stage]

/// Every mover goes on to the end of the part, with an even acceleration.
void move_bodies(const SteppedSetup& setup, SteppedState& state, StepPart& part);

namespace detail {

/// How a mover turns through a part: evenly, with the mean of its spins at both ends.
inline Vector3<double> mean_spin(const SteppedState& state, const StepPart& part, std::size_t i,
                                 double length) {
  if (part.at_start[i]) return part.end_spin[i];
  const Vector3<double> change = part.end_spin[i] - state.spin[i];
  return state.spin[i] + change * (length / part.planned / 2);
}

/// The spin at the end of a part of this length, as forces alone make it.
inline Vector3<double> pushed_spin(const SteppedState& state, const StepPart& part, std::size_t i,
                                   double length) {
  if (part.at_start[i] || length == part.planned) return part.end_spin[i];
  const Vector3<double> change = part.end_spin[i] - state.spin[i];
  return state.spin[i] + change * (length / part.planned);
}

/// How a mover lies after a part of this length, if its spin is even.
inline Rotor<double> turned_evenly(const SteppedState& state, const StepPart& part, std::size_t i,
                                   double length) {
  return normalised(
      exponential_step(state.orientation[i], mean_spin(state, part, i, length), length));
}

}  // namespace detail

/// Every mover turns with an even spin. Right where its spin stays as it is if nothing pushes: for
/// a body whose moments are equal, or that turns about a principal axis.
void turn_bodies(const SteppedSetup& setup, SteppedState& state, StepPart& part);

namespace detail {

/// The angular momentum of a body that lies so and spins so, in the world, kg·m²/s.
inline Vector3<double> momentum_of_spin(const SteppedBody& body, const Rotor<double>& q,
                                        const Vector3<double>& spin) {
  const Matrix3<double> principal = matrix_of(q) * body.axes;
  const Vector3<double> seen = principal.transpose() * spin;
  return principal * Vector3<double>(seen.cwiseProduct(body.moments));
}

/// largest_free_square() of a body that lies so and spins so, in the world, rad²/s².
inline double largest_free_square(const SteppedBody& body, const Rotor<double>& q,
                                  const Vector3<double>& spin) {
  const Vector3<double> seen = (matrix_of(q) * body.axes).transpose() * spin;
  return contact::largest_free_square(body.moments, seen);
}

/// How a mover lies after a part of this length: while contacts push, it turns as with the mean of
/// its momenta.
Rotor<double> turned_freely(const SteppedSetup& setup, const SteppedState& state,
                            const StepPart& part, std::size_t i, double length);

}  // namespace detail

/// Turning with the gyroscopic term: the angular momentum is what contacts leave of it, and the
/// spin follows from how the body lies.
void turn_with_gyroscopic_term(const SteppedSetup& setup, SteppedState& state, StepPart& part);

/// How often overlaps are gone through: each time half of what is left is taken out.
inline constexpr int push_out_rounds = 8;

/// Takes overlaps of hard bodies out, by moving the two of each apart along their normal, the
/// lighter one farther. Velocities stay, so no energy of motion comes of it.
///
/// Turning leaves such overlaps: contacts hold the points where bodies touch, and these wander. So
/// do sweeps that end before they are done.
void push_out(const SteppedSetup& setup, SteppedState& state, StepPart& part);

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/stage_motion.cpp"
#endif
