/// @file
/// Stages: bodies at rest that are left alone, and overlaps that are taken out.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include <contact/stage_contacts.hpp>
#include <contact/stepped_state.hpp>

namespace contact {

/// How long a body must have been slow to fall asleep, s.
inline constexpr double sleep_after = 0.5;

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

// [sleeping-stage]
/// Puts groups of bodies to sleep that touch each other and have all been slow for half a second.
///
/// Slow is what would come no farther than the tolerance in all the time of the scene. A body that
/// touches nothing does not sleep.
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
    if (setup.rotation) state.spin[i].setZero();
    ++state.counts.rests;
  }
}
// [/sleeping-stage]

// [pushing-out-stage]
/// How often overlaps are gone through: each time half of what is left is taken out.
inline constexpr int push_out_rounds = 8;

/// Takes overlaps of hard bodies out, by moving the two of each apart along their normal, the
/// lighter one farther. Velocities stay, so no energy of motion comes of it.
///
/// Turning leaves such overlaps: contacts hold the points where bodies touch, and these wander. So
/// do sweeps that end before they are done.
inline void push_out(const SteppedSetup& setup, SteppedState& state, StepPart& part) {
  std::vector<Vector3<double>> moved;  // of each mover, so far
  const auto lightness = [&](std::size_t place) {
    return place < setup.movers && !sleeps(state, place) ? 1 / setup.bodies[place].mass : 0.0;
  };
  for (int round = 0; round < push_out_rounds; ++round) {
    for (const NearPair& pair : part.pairs) {
      const double slack = 0x1p10 * pair.touch;
      if (pair.material.stiffness || !pair.touching || pair.distance >= -slack) continue;
      if (moved.empty()) moved.assign(setup.movers, Vector3<double>::Zero());
      const double a = lightness(pair.a);
      const double b = lightness(pair.b);
      const Vector3<double>& n = pair.manifold.normal;
      double depth = -pair.distance - slack - n.dot(moved[pair.a]);
      if (pair.b < setup.movers) depth += n.dot(moved[pair.b]);
      if (!(depth > 0) || !(a + b > 0)) continue;
      const Vector3<double> way = n * (depth / 2 / (a + b));
      if (a > 0) moved[pair.a] += way * a;
      if (b > 0) moved[pair.b] -= way * b;
    }
    if (moved.empty()) return;
  }
  for (std::size_t i = 0; i < setup.movers; ++i) state.position.add(i, moved[i]);
}
// [/pushing-out-stage]

}  // namespace contact
