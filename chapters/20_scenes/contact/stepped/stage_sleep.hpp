/// @file
/// Stages: groups of bodies that rest together are skipped; and bodies that a fast body touches
/// wake.
#pragma once

#include <contact/stepped/stepped_state.hpp>

namespace contact {

/// Puts groups of bodies to sleep that touch each other and have all been slow for half a second.
///
/// A body is slow if it would not move farther than the tolerance during the whole scene, even if
/// its speed came from an acceleration within that half second that continues. A body that touches
/// nothing does not sleep.
void put_to_sleep(const SteppedSetup& setup, SteppedState& state, Substep& substep);

/// Wakes sleepers that a fast body touches, and all that fell asleep with them.
void wake_bodies(const SteppedSetup& setup, SteppedState& state, Substep& substep);

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/stage_sleep.cpp"
#endif
