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
    const Vector3<double> velocity = state.velocity[i];
    const Vector3<double> end = part.end_velocity[i];
    const Vector3<double> change = end - velocity;
    if (part.at_start[i] || part.length == part.planned) {
      const Vector3<double> mean = part.at_start[i] ? end : Vector3<double>(velocity + change / 2);
      state.position.add(i, mean * part.length);
      state.velocity.set(i, end);
    } else {
      const Vector3<double> mean = velocity + change * (share / 2);
      state.position.add(i, mean * part.length);
      state.velocity.add(i, change * share);
    }
  }
}
// [/moving-stage]

}  // namespace contact
