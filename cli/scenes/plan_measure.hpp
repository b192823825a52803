#pragma once

// What the effects of a plan cost, measured: the run as planned beside runs in which one effect is
// the other way round.

#include <vector>

#include <contact/plan/plan_report.hpp>
#include <contact/plan/plan_types.hpp>
#include <contact/scene/scene.hpp>

#include "../terminal/progress_line.hpp"

namespace contact::cli {

/// Measures each effect that can be switched, in turns with the run as planned: medians of five;
/// and the horizon, by a run that begins an ulp away.
/// How far it has come is the one piece of `progress`.
std::vector<scenes::MeasuredEffect> measure_effects(const Scene& scene, const Plan& plan,
                                                    const PlanOptions& options,
                                                    ProgressLine& progress);

}  // namespace contact::cli
