/// @file
/// Stages: the events of contacts that end a substep. A sliding contact comes to rest, and a round
/// body passes the edge of the face that supports it: forces change at these instants, and a
/// substep has constant ones.
#pragma once

#include <contact/stepped/stepped_state.hpp>

namespace contact {

/// The largest number of substeps of a step that events of contacts end. Later events of the step
/// fall inside a substep.
inline int max_contact_events(const SteppedSetup& setup) {
  return setup.max_impacts < 16 ? setup.max_impacts : 16;
}

/// Whether a ball or a capsule may roll over an edge: of a box or of a hull.
bool passes_edges(const SteppedSetup& setup);

/// Finds the first instant at which a contact that slides comes to rest, or reverses: its
/// tangential velocity u has then no component along its initial one. A ball that slides begins to
/// roll then.
///
/// Between two events the velocities change linearly, since the solver's impulses are proportional
/// to the length of the substep. So a substep that is short enough for all to slide gives the rate,
/// and from it the time: the substep is repeated with a sixteenth of its length until that is so,
/// and then with the time found. Only where impacts are taken one by one, and at most
/// max_contact_events() times a step.
void find_end_of_sliding(const SteppedSetup& setup, SteppedState& state, Substep& substep);

/// How far the surfaces of a pair separate in the substep if both bodies move on with their present
/// velocities, m; 0 where a ball or a capsule stays over a face. Only for a ball or capsule that
/// slides or rolls over an edge or a vertex of a box or a hull, which curves away below it from the
/// beginning of the substep: if it falls less in this time, it takes off.
double falling_away(const SteppedSetup& setup, const SteppedState& state, const Substep& substep,
                    const NearPair& pair);

/// Ends the substep when the first ball or capsule passes the edge of the face that it touches: the
/// contact normal is constant before and rotates afterwards. The instant is found by bisection, up
/// to a rotation of the normal by 2^-30.
void find_end_of_support(const SteppedSetup& setup, SteppedState& state, Substep& substep);

/// Records what the forces of this substep leave open: whether they are constant in it, as the
/// motion requires. They are where contact normals keep their direction, no body with vertices
/// rotates and friction keeps its direction: for all else, no error is known.
void note_varying_forces(const SteppedSetup& setup, SteppedState& state, Substep& substep);

/// Records that a pair meets so slowly that it does not bounce, where that stands for a force that
/// varies: a body that rolls over a curved surface falls on it again in each step.
/// @param speed of approach, m/s
void note_slow_impact(const SteppedSetup& setup, SteppedState& state, const Substep& substep,
                      const NearPair& pair, double speed);

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/stage_contact_events.cpp"
#endif
