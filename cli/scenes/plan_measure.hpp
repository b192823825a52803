#pragma once

// The measured costs of a plan's effects: the run as planned beside runs with one effect switched.

#include <vector>

#include <contact/plan/plan_report.hpp>
#include <contact/plan/plan_types.hpp>
#include <contact/scene/scene.hpp>

#include "../terminal/progress_line.hpp"

namespace contact::cli {

/// Measures each effect that can be switched, in turns with the run as planned: medians of five;
/// and the horizon, by a run that starts an ulp away. Its progress is the one piece of `progress`.
std::vector<scenes::MeasuredEffect> measure_effects(const Scene& scene, const Plan& plan,
                                                    const PlanOptions& options,
                                                    ProgressLine& progress);

}  // namespace contact::cli
