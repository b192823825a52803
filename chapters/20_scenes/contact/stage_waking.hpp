/// @file
/// A stage: what something fast touches sleeps no longer.
#pragma once

#include <cstddef>
#include <cstdint>

#include <contact/stage_sleep.hpp>
#include <contact/stepped_state.hpp>

namespace contact {

// [waking-stage]
/// Wakes sleepers that something fast touches, and all that fell asleep with them.
inline void wake_bodies(const SteppedSetup& setup, SteppedState& state, StepPart& part) {
  bool woken = false;
  const auto wake = [&](std::size_t sleeper, std::size_t other) {
    if (!sleeps(state, sleeper) || other >= setup.movers || sleeps(state, other)) return;
    if (detail::is_slow(setup, state, other)) return;
    woken = true;
    const std::int32_t group = state.sleeps_with[sleeper];
    for (std::size_t i = 0; i < setup.movers; ++i) {
      if (state.sleeps_with[i] != group) continue;
      state.sleeps_with[i] = -1;
      state.slow_since[i] = 0;
    }
  };
  for (const NearPair& pair : part.pairs) {
    if (!pair.touching && !(part.at_once && pair.distance <= pair.reach)) continue;
    if (pair.b >= setup.movers) continue;
    wake(pair.a, pair.b);
    wake(pair.b, pair.a);
  }
  // Pairs among those that wake were left out: look again, before time goes on.
  if (woken) part.length = 0;
}
// [/waking-stage]

}  // namespace contact
