/// @file
/// A stage: the lasting forces that hold bodies on each other.
#pragma once

#include <contact/contact_active_set.hpp>
#include <contact/stepped/stepped_state.hpp>

namespace contact {

/// The lasting forces: normal forces and friction of contacts through this substep.
///
/// Points that touch do not approach. A distance may decrease to zero, and not below. A force is
/// constant, so its body moves with the mean of its velocities at both ends of the substep. A
/// contact that closes a distance acts at the start: along the normal its body has its final
/// velocity all through, and does not move too far; neither does a body that it pushes.
///
/// Where all impacts of the step are taken at once, bodies first come to touch. The stage of
/// bounces makes them bounce then: it gets the velocities that each would have without contacts.
void solve_forces(const SteppedSetup& setup, SteppedState& state, Substep& substep);

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/stage_forces.cpp"
#endif
