/// @file
/// A stage: gravity.
#pragma once

#include <cstddef>

#include <contact/stepped_state.hpp>

namespace contact {

// [gravity-stage]
/// Gravity changes the velocity that each mover has at the end of the part.
inline void add_gravity(const SteppedSetup& setup, SteppedState& state, StepPart& part) {
  const Vector3<double> change = setup.scene.gravity * part.planned;
  for (std::size_t i = 0; i < setup.movers; ++i) {
    if (!sleeps(state, i)) part.end_velocity.add(i, change);
  }
}
// [/gravity-stage]

}  // namespace contact
