/// @file
/// A stage: continuous detection by conservative advancement. The substep ends at the first instant
/// at which two bodies meet.
#pragma once

#include <cstddef>
#include <optional>

#include <contact/stepped/stepped_state.hpp>

namespace contact {

/// When a pair first touches in a substep; empty if not before the given time.
///
/// Along the normal between their nearest points, each vertex of the one is above each vertex of
/// the other. The rate of such a height is known, and so is a bound on the change of that rate. The
/// bodies cannot touch before the first of these heights reaches zero: advance to then, and test
/// again (conservative advancement). A ball and a plane take one test, rotating and oblique bodies
/// take a few. In a pair that separates, a vertex may hang over the other's edge and come down
/// beside it: the substep ends before it has penetrated by a sixteenth of half the thickness.
/// @param before s
/// @return s; never later than the touch, and earlier only after 64 tests
std::optional<double> pair_impact(const SteppedSetup& setup, const SteppedState& state,
                                  const Substep& substep, const NearPair& pair, double before);

/// Ends the substep when the first of the separate pairs comes to touch. Pairs that touch already
/// are kept apart by their contacts.
void find_first_impact(const SteppedSetup& setup, SteppedState& state, Substep& substep);

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/stage_time_of_impact.cpp"
#endif
