/// @file
/// A stage: every mover goes on its way. What nothing touches flies exactly.
#pragma once

#include <cstddef>

#include <contact/stepped_state.hpp>

namespace contact {

// [moving-stage]
/// Every mover goes on to the end of the part, with an even acceleration: exact for a flight, and
/// for a block that slides. A part that an impact cuts short ends with the velocity of that moment.
inline void move_bodies(const SteppedSetup& setup, SteppedState& state, StepPart& part) {
  const double share = part.length / part.planned;
  for (std::size_t i = 0; i < setup.movers; ++i) {
    if (sleeps(state, i)) continue;
    const Vector3<double> first = first_velocity(state, part, i);
    const Vector3<double> end = part.end_velocity[i];
    const Vector3<double> change = end - first;
    state.position.add(i, Vector3<double>(first + change * (share / 2)) * part.length);
    state.velocity.set(i, share < 1 ? Vector3<double>(first + change * share) : end);
  }
}
// [/moving-stage]

}  // namespace contact
