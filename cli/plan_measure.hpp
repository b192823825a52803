#pragma once

// What the effects of a plan cost, measured: the run as planned beside runs in which one effect is
// the other way round.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <contact/plan/plan_types.hpp>
#include <contact/scene/scene.hpp>

#include "progress_line.hpp"

namespace contact::cli {

/// How long a run stays with its twin, which begins an ulp away.
struct MeasuredHorizon {
  double time = 0;     ///< when they were last compared, s
  double apart = 0;    ///< how far the farthest two places were apart then, m
  double allowed = 0;  ///< the tolerance, or without one the least radius of what moves, m
  [[nodiscard]] bool parted() const { return apart > allowed; }
};

/// One effect the other way round; of the horizon, the run beside its twin.
struct MeasuredEffect {
  Effect effect = Effect::gravity;
  std::optional<MeasuredHorizon> horizon;  ///< nothing more is measured then
  bool same_stages = false;       ///< the run is composed alike: there is nothing to measure
  std::string refused;            ///< why there is no such run; empty if there is one
  double planned_seconds = 0;     ///< of the processor for a second of the scene, as planned
  double other_seconds = 0;       ///< the same the other way round
  std::size_t planned_bytes = 0;  ///< of one moving body's state
  std::size_t other_bytes = 0;    ///< the same the other way round
};

/// Measures each effect that can be switched, in turns with the run as planned: medians of five;
/// and the horizon, by a run that begins an ulp away.
/// How far it has come is the one piece of `progress`.
std::vector<MeasuredEffect> measure_effects(const Scene& scene, const Plan& plan,
                                            const PlanOptions& options, ProgressLine& progress);

/// "Measured: 0.52 ms a second as planned, 0.81 ms with it (1.6 times), ...".
std::string measured_text(const MeasuredEffect& measured, bool on);

}  // namespace contact::cli
