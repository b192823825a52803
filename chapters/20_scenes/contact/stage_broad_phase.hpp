/// @file
/// A stage: the broad phase, in place of comparing each with each.
#pragma once

#include <span>

#include <contact/aabb.hpp>
#include <contact/grid_pairs.hpp>
#include <contact/stage_pairs.hpp>
#include <contact/stepped_state.hpp>

namespace contact {

// [broad-phase-stage]
/// The broad phase: cells, and each asks its neighbours. It finds the same pairs.
inline void sort_into_cells(const SteppedSetup& setup, SteppedState& state, StepPart& part) {
  detail::find_near_pairs(setup, state, part,
                          [](std::span<const Aabb<double>> boxes) { return grid_pairs(boxes); });
}
// [/broad-phase-stage]

}  // namespace contact
