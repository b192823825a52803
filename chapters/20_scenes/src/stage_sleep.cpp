#include <contact/stepped/stage_sleep.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include <contact/contact_manifold.hpp>
#include <contact/contact_solver.hpp>
#include <contact/inertia.hpp>
#include <contact/plan/plan_types.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/scene/scene_run.hpp>
#include <contact/signed_distance.hpp>
#include <contact/stepped/stepped_state.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// The first of a body's group; groups are trees of which each node points towards the first.
CONTACT_SCENES_INLINE std::size_t first_of_group(std::vector<std::size_t>& group, std::size_t i) {
  while (group[i] != i) i = group[i] = group[group[i]];
  return i;
}

CONTACT_SCENES_INLINE bool is_slow(const SteppedSetup& setup, const SteppedState& state,
                                   std::size_t i) {
  const double turning = size_of(angular_velocity_of(state, i)) * setup.bodies[i].bounding_radius;
  return size_of(state.velocity[i]) + turning <= setup.sleep_speed;
}

}  // namespace detail

// [sleeping-stage]
CONTACT_SCENES_INLINE void put_to_sleep(const SteppedSetup& setup, SteppedState& state,
                                        Substep& substep) {
  std::vector<std::size_t> group(setup.movers);
  std::iota(group.begin(), group.end(), std::size_t{0});
  std::vector<bool> touches(setup.movers, false);
  for (const NearPair& pair : substep.pairs) {
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
    const double now = time_of_substep(setup, state, substep);
    const double creeps = size_of(state.velocity[i]) +
                          size_of(angular_velocity_of(state, i)) * setup.bodies[i].rotation_radius;
    if (creeps * std::max(setup.scene.duration - now, setup.step) > min_error(setup))
      state.counts.doubts.add(RunDoubt::rest, now);
    state.velocity.set(i, Vector3<double>::Zero());
    if (setup.rotation) state.angular_velocity.set(i, Vector3<double>::Zero());
    ++state.counts.rests;
  }
}
// [/sleeping-stage]

// [waking-stage]
CONTACT_SCENES_INLINE void wake_bodies(const SteppedSetup& setup, SteppedState& state,
                                       Substep& substep) {
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
  for (const NearPair& pair : substep.pairs) {
    if (!pair.touching && !(substep.simultaneous && pair.distance <= pair.closing_distance))
      continue;
    if (pair.b >= setup.movers) continue;
    wake(pair.a, pair.b);
    wake(pair.b, pair.a);
  }
  // Pairs among those that wake were left out: search again, before time goes on.
  if (woken) substep.length = 0;
}
// [/waking-stage]

}  // namespace contact
