/// @file
/// A stage: groups of bodies that rest together are left alone.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include <contact/stepped_state.hpp>

namespace contact {

namespace detail {

/// The first of a body's group; groups are trees of which each points towards its first.
inline std::size_t first_of_group(std::vector<std::size_t>& group, std::size_t i) {
  while (group[i] != i) i = group[i] = group[group[i]];
  return i;
}

inline bool is_slow(const SteppedSetup& setup, const SteppedState& state, std::size_t i) {
  const double turning = size_of(spin_of(state, i)) * setup.bodies[i].reach;
  return size_of(state.velocity[i]) + turning <= setup.sleep_speed;
}

}  // namespace detail

// [sleeping-stage]
/// Puts groups of bodies to sleep that touch each other and have all been slow for half a second.
///
/// Slow is what would come no farther than the tolerance in all the time of the scene, even if it
/// had come to its speed within that half second and what pushed it so went on. A body that touches
/// nothing does not sleep.
inline void put_to_sleep(const SteppedSetup& setup, SteppedState& state, StepPart& part) {
  std::vector<std::size_t> group(setup.movers);
  std::iota(group.begin(), group.end(), std::size_t{0});
  std::vector<bool> touches(setup.movers, false);
  for (const NearPair& pair : part.pairs) {
    if (!pair.touching) continue;
    touches[pair.a] = true;
    if (pair.b >= setup.movers) continue;
    touches[pair.b] = true;
    const std::size_t a = detail::first_of_group(group, pair.a);
    const std::size_t b = detail::first_of_group(group, pair.b);
    group[std::max(a, b)] = std::min(a, b);
  }
  std::vector<bool> ready(setup.movers, true);
  for (std::size_t i = 0; i < setup.movers; ++i) {
    if (sleeps(state, i)) continue;
    const bool slow = touches[i] && detail::is_slow(setup, state, i);
    state.slow_since[i] = slow ? state.slow_since[i] + setup.step : 0;
    if (state.slow_since[i] < sleep_after) ready[detail::first_of_group(group, i)] = false;
  }
  for (std::size_t i = 0; i < setup.movers; ++i) {
    const std::size_t first = detail::first_of_group(group, i);
    if (sleeps(state, i) || !ready[first]) continue;
    state.sleeps_with[i] = static_cast<std::int32_t>(first);
    state.velocity.set(i, Vector3<double>::Zero());
    if (setup.rotation) state.spin.set(i, Vector3<double>::Zero());
    ++state.counts.rests;
  }
}
// [/sleeping-stage]

}  // namespace contact
