/// @file
/// A stage: impacts at one moment.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <contact/contact_solver.hpp>
#include <contact/stage_contacts.hpp>
#include <contact/step_solver.hpp>
#include <contact/stepped_state.hpp>

namespace contact {

// [impacts-stage]
/// Impacts of pairs that touch now and approach: each leaves with e times the speed with which it
/// came, or with none if that is slower than slowest_bounce(). All that touch at this moment are
/// solved together. Such a part has no length: velocities change, and no time passes.
inline void solve_impacts(const SteppedSetup& setup, SteppedState& state, StepPart& part) {
  if (part.at_once) return;
  std::vector<BodyContact<double>> contacts;
  std::vector<std::pair<std::size_t, std::size_t>> hits;  // first and one past the last contact
  bool approaches = false;
  for (const NearPair& pair : part.pairs) {
    if (!pair.touching || pair.material.stiffness) continue;
    const std::size_t first = contacts.size();
    bool hit = false;
    bool lay_down = false;
    const double slowest =
        std::max(slowest_bounce(setup, pair.b >= setup.movers, pair.manifold.normal), pair.slow);
    for (const auto& point : pair.manifold.points) {
      if (point.distance > pair.near) continue;
      const double speed = parting_speed(setup, state, pair, point.point);
      const bool fast = speed < -slowest;
      contacts.push_back(
          detail::contact_at(pair, point, fast ? -(pair.material.restitution * speed) : 0.0));
      hit = hit || fast;
      approaches = approaches || speed < -pair.slow;
      if (!fast && speed < -pair.slow && pair.material.restitution > 0) lay_down = true;
    }
    if (hit) hits.push_back({first, contacts.size()});
    if (lay_down && !hit) ++state.counts.rests;
  }
  if (!approaches) return;
  const auto impulses = detail::solve_now(setup, state, contacts);
  for (const auto& [first, last] : hits)
    detail::note_hit(setup, state, part, contacts, impulses, first, last);
  part.length = 0;
  ++part.cuts;
}
// [/impacts-stage]

}  // namespace contact
