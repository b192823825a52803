/// @file
/// A stage: groups of bodies that rest together are left alone.
/// A stage: what something fast touches sleeps no longer.
#pragma once

#include <contact/stepped/stepped_state.hpp>

namespace contact {

/// Puts groups of bodies to sleep that touch each other and have all been slow for half a second.
///
/// Slow is what would come no farther than the tolerance in all the time of the scene, even if it
/// had come to its speed within that half second and what pushed it so went on. A body that touches
/// nothing does not sleep.
void put_to_sleep(const SteppedSetup& setup, SteppedState& state, StepPart& part);

/// Wakes sleepers that something fast touches, and all that fell asleep with them.
void wake_bodies(const SteppedSetup& setup, SteppedState& state, StepPart& part);

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/stage_sleep.cpp"
#endif
