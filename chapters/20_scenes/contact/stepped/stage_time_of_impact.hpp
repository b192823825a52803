/// @file
/// A stage: continuous detection. The part ends at the first moment at which two bodies meet.
#pragma once

#include <cstddef>
#include <optional>

#include <contact/rotation.hpp>
#include <contact/stepped/stepped_state.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// How fast it turns then, but for PartMotion::unforeseen.
Vector3<double> spin_at(const SteppedSetup& setup, const SteppedState& state, const StepPart& part,
                        std::size_t place, double t, const Rotor<double>& orientation);

}  // namespace detail

/// When a pair first touches in a part; nothing if not before the given time.
///
/// Seen along the normal between their nearest points, each corner of the one is above each corner
/// of the other. How fast such a height changes is known, and how fast that rate may change. Until
/// the first of these heights is used up the bodies cannot touch: advance there, and look again. A
/// ball and a plane take one look, what turns or comes at a slant takes a few. Of a pair that
/// leaves, a corner may hang over the other's edge and come down beside it: before that has come
/// into it by a sixteenth of half a thickness the part ends.
/// @param before s
/// @return s; never later than the touch, and earlier only after 64 looks
std::optional<double> pair_impact(const SteppedSetup& setup, const SteppedState& state,
                                  const StepPart& part, const NearPair& pair, double before);

/// Ends the part where the first of the pairs that are apart comes to touch. What touches already
/// is kept apart by its contacts.
void find_first_impact(const SteppedSetup& setup, SteppedState& state, StepPart& part);

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/stage_time_of_impact.cpp"
#endif
