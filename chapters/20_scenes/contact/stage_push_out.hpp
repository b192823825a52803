/// @file
/// A stage: overlaps that turning and unfinished sweeps have left are taken out.
#pragma once

#include <cstddef>
#include <vector>

#include <contact/stepped_state.hpp>

namespace contact {

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
