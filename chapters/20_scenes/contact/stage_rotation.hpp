/// @file
/// A stage: every mover turns, with an even spin.
#pragma once

#include <cstddef>

#include <contact/rotation.hpp>
#include <contact/stepped_state.hpp>

namespace contact {

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

// [turning-stage]
/// Every mover turns with an even spin. Right where its spin stays as it is if nothing pushes: for
/// a body whose moments are equal, or that turns about a principal axis.
inline void turn_bodies(const SteppedSetup& setup, SteppedState& state, StepPart& part) {
  for (std::size_t i = 0; i < setup.movers; ++i) {
    if (sleeps(state, i)) continue;
    state.orientation[i] = detail::turned_evenly(state, part, i, part.length);
    state.spin.set(i, detail::pushed_spin(state, part, i, part.length));
  }
}
// [/turning-stage]

}  // namespace contact
