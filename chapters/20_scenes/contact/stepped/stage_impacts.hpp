/// @file
/// Stages: impacts at one instant; the bounces of impacts that are taken all at once; compliant
/// contacts, where springs and dampers push while two surfaces overlap.
#pragma once

#include <contact/contact_active_set.hpp>
#include <contact/rigid_impulse.hpp>
#include <contact/stepped/stepped_state.hpp>

namespace contact {

/// Impacts of pairs that touch now and approach: each leaves with e times its approach speed, or
/// with 0 if that is slower than slowest_bounce(). All contacts at this instant are solved
/// together. Such a substep has length zero: velocities change, and no time passes.
void solve_impacts(const SteppedSetup& setup, SteppedState& state, Substep& substep);

/// The bounces of impacts that are taken all at once, by restitution.
///
/// All contacts that push are solved once more, from the velocities before they push. A pair leaves
/// with e times its approach speed; if it were stopped first, bouncing would create energy.
/// Momentum is conserved up to rounding. A bounce adds no energy: where it would, because gravity
/// has changed the velocities for the whole substep and a contact has kept a body from moving that
/// far, connected bodies get only a part of it. Contact forces between two impacts may still add
/// some. Without gravity and friction energy is conserved at e = 1, except for residuals of the
/// iterations.
void solve_bounces(const SteppedSetup& setup, SteppedState& state, Substep& substep);

/// Bodies that have bounced are touching by now, and leave. A body that has rotated meanwhile keeps
/// its angular velocity in its own axes, and so its energy. Its angular momentum is wrong by that
/// rotation.
void apply_bounces(const SteppedSetup& setup, SteppedState& state, Substep& substep);

/// Springs and dampers of the pairs that overlap, in the middle of the substep: leapfrog (velocity
/// Verlet). A spring alone conserves its energy up to the square of the substep's share of its
/// period, and a substep is at most 1/128 of a radian of the stiffest spring long.
///
/// The damper acts on the velocity at the end of the substep, so that no damper is too strong (16's
/// implicit damper). A pair's spring is shared by its contact points. Friction stops sliding within
/// the substep, within Coulomb's bound.
void apply_spring_forces(const SteppedSetup& setup, SteppedState& state, Substep& substep);

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/stage_impacts.cpp"
#endif
