/// @file
/// Stages that find the pairs that may touch in the rest of the step: by comparing all, or by a
/// broad phase.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <contact/aabb.hpp>
#include <contact/box_pairs.hpp>
#include <contact/contact_solver.hpp>
#include <contact/grid_pairs.hpp>
#include <contact/inertia.hpp>
#include <contact/stepped/stepped_state.hpp>

namespace contact {

/// How far a mover may deviate from its straight path in the rest of the step, m: by gravity, by
/// rotation, and where a body throws it. A little is added, so that resting bodies have some room
/// too.
double room_of_sweep(const SteppedSetup& setup, const SteppedState& state, const StepPart& part,
                     std::size_t place);

/// A box that contains a body during all of the rest of the step.
Aabb<double> swept_box(const SteppedSetup& setup, const SteppedState& state, const StepPart& part,
                       std::size_t place);

namespace detail {

/// Stores the pairs of a search, and those of movers that may reach a half-space.
void note_pairs(const SteppedSetup& setup, const SteppedState& state, StepPart& part,
                std::span<const Aabb<double>> boxes, std::vector<BoxPair> found);

/// How far two bodies may approach each other in the rest of the step.
double pair_reach(const SteppedSetup& setup, const SteppedState& state, const StepPart& part,
                  const NearPair& pair);

template <class Search>
void find_near_pairs(const SteppedSetup& setup, SteppedState& state, StepPart& part,
                     const Search& search) {
  std::vector<Aabb<double>> boxes;
  boxes.reserve(setup.bounded);
  for (std::size_t i = 0; i < setup.bounded; ++i) boxes.push_back(swept_box(setup, state, part, i));
  const std::span<const Aabb<double>> all(boxes);
  note_pairs(setup, state, part, all, search(all).pairs);
  state.counts.pairs += part.pairs.size();
}

}  // namespace detail

/// Where all impacts are taken at once: whether a body is thrown at another that was not near
/// before. Then part.flung says how far each deviates from its path, and the substep is to be
/// repeated.
/// @param find the stage that finds pairs
bool flung_at_others(const SteppedSetup& setup, SteppedState& state, StepPart& part,
                     StepStage find);

// [pairs-stage]
/// The stage without a broad phase: the box of each is compared with the box of each other.
inline void compare_all_pairs(const SteppedSetup& setup, SteppedState& state, StepPart& part) {
  detail::find_near_pairs(setup, state, part,
                          [](std::span<const Aabb<double>> boxes) { return all_pairs(boxes); });
}
// [/pairs-stage]

// [broad-phase-stage]
/// The broad phase: cells, in which each tests its neighbours. It finds the same pairs.
inline void sort_into_cells(const SteppedSetup& setup, SteppedState& state, StepPart& part) {
  detail::find_near_pairs(setup, state, part,
                          [](std::span<const Aabb<double>> boxes) { return grid_pairs(boxes); });
}
// [/broad-phase-stage]

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/stage_pairs.cpp"
#endif
