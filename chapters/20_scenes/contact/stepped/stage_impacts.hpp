/// @file
/// A stage: impacts at one moment.
/// A stage: the bounces of impacts that were taken all at once.
/// A stage: contacts that give way. Springs and dampers push while two surfaces overlap.
#pragma once

#include <contact/contact_finish.hpp>
#include <contact/rigid_impulse.hpp>
#include <contact/stepped/stepped_state.hpp>

namespace contact {

/// Impacts of pairs that touch now and approach: each leaves with e times the speed with which it
/// came, or with none if that is slower than slowest_bounce(). All that touch at this moment are
/// solved together. Such a part has no length: velocities change, and no time passes.
void solve_impacts(const SteppedSetup& setup, SteppedState& state, StepPart& part);

/// Of impacts that are taken all at once: how each leaves, as restitution says.
///
/// All that pushes is solved once more, from the velocities that are there before it pushes. A pair
/// leaves with e times the speed at which it comes; had it been stopped first, to bounce would make
/// energy. Momentum is kept to rounding. Energy is kept where nothing rubs and e is 1, but for what
/// unfinished sweeps leave.
void solve_bounces(const SteppedSetup& setup, SteppedState& state, StepPart& part);

/// Who has bounced has come to touch by now, and leaves. What has turned meanwhile spins as before
/// in its own axes: so it has the same energy. Its angular momentum is off by what it has turned.
void leave_bounced(const SteppedSetup& setup, SteppedState& state, StepPart& part);

/// Springs and dampers of the pairs that overlap, at the middle of the part: leapfrog. A spring
/// alone keeps its energy but for the square of the part's share of its period, and a part is
/// at most 1/128 of a radian of the stiffest spring long.
///
/// The damper sees the velocity at the end of the part, so that no damper is too strong for a part
/// (16's implicit damper). A pair's spring is shared by the points at which it touches. Friction
/// stops what slides within the part, if Coulomb's bound lets it.
void push_springs(const SteppedSetup& setup, SteppedState& state, StepPart& part);

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/stage_impacts.cpp"
#endif
