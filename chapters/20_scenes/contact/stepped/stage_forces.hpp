/// @file
/// A stage: the forces that last, and hold bodies on each other.
#pragma once

#include <contact/contact_finish.hpp>
#include <contact/stepped/stepped_state.hpp>

namespace contact {

/// The forces that last: what holds bodies on each other, and rubs them, through this part.
///
/// Points that touch do not come closer. A gap may close, and no more. A force acts evenly, so its
/// body moves with the mean of the velocities at both ends of the part. What closes a gap acts at
/// the start: its body has its end velocity all through along the normal, and does not come too
/// far; so has what that pushes on.
///
/// Where all impacts of the step are taken at once, each first comes to touch. How it bounces
/// then is the business of the bounces stage: it is told how each would have come without a push.
void solve_forces(const SteppedSetup& setup, SteppedState& state, StepPart& part);

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/stage_forces.cpp"
#endif
