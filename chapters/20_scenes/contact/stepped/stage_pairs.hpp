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
double swept_margin(const SteppedSetup& setup, const SteppedState& state, const Substep& substep,
                    std::size_t slot);

/// A box that contains a body during all of the rest of the step.
Aabb<double> swept_box(const SteppedSetup& setup, const SteppedState& state, const Substep& substep,
                       std::size_t slot);

namespace detail {

/// Stores the pairs of a search, and those of movers that may reach a half-space.
/// @param found in increasing order
void record_pairs(const SteppedSetup& setup, const SteppedState& state, Substep& substep,
                  std::span<const Aabb<double>> boxes, std::vector<BoxPair> found);

/// How far two bodies may approach each other in the rest of the step.
double pair_closing_distance(const SteppedSetup& setup, const SteppedState& state,
                             const Substep& substep, const NearPair& pair);

template <class Search>
void find_near_pairs(const SteppedSetup& setup, SteppedState& state, Substep& substep,
                     const Search& search) {
  std::vector<Aabb<double>> boxes;
  boxes.reserve(setup.bounded);
  for (std::size_t i = 0; i < setup.bounded; ++i)
    boxes.push_back(swept_box(setup, state, substep, i));
  const std::span<const Aabb<double>> all(boxes);
  record_pairs(setup, state, substep, all, search(all).pairs);
  state.counts.pairs += substep.pairs.size();
}

}  // namespace detail

/// Where all impacts are taken at once: whether a body is thrown at another that was not near
/// before. Then substep.deflection says how far each deviates from its path, and the substep is to
/// be repeated.
bool deflected_at_others(const SteppedSetup& setup, const SteppedState& state, Substep& substep);

// [pairs-stage]
/// The stage without a broad phase: the box of each is compared with the box of each other.
inline void compare_all_pairs(const SteppedSetup& setup, SteppedState& state, Substep& substep) {
  detail::find_near_pairs(setup, state, substep,
                          [](std::span<const Aabb<double>> boxes) { return all_pairs(boxes); });
}
// [/pairs-stage]

// [broad-phase-stage]
/// The broad phase: cells, in which each tests its neighbours. It finds the same pairs.
inline void sort_into_cells(const SteppedSetup& setup, SteppedState& state, Substep& substep) {
  detail::find_near_pairs(setup, state, substep,
                          [](std::span<const Aabb<double>> boxes) { return grid_pairs(boxes); });
}
// [/broad-phase-stage]

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/stage_pairs.cpp"
#endif
