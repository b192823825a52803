/// @file
/// The planner: decides for each effect whether it can matter in a scene, before the scene runs.
#pragma once

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include <contact/broad_phase_cost.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/plan/plan_types.hpp>
#include <contact/scene/scene.hpp>

namespace contact {

namespace detail {

inline bool is_listed(const std::vector<Effect>& effects, Effect effect) {
  return std::find(effects.begin(), effects.end(), effect) != effects.end();
}

/// Whether an effect is forced off that the plan has on, so that the error has no bound. Bodies may
/// always stay awake, pairs unsorted, and an event-driven scene may go in steps.
bool has_no_bound(const Plan& plan, const Decision& decision);

/// A number for a sentence: four digits.
inline std::string short_number(double x) {
  char text[48];
  std::snprintf(text, sizeof text, "%.4g", x);
  return text;
}

}  // namespace detail

/// The plan of a scene.
///
/// An effect is off by a proof or a bound; an effect that no rule can prove inactive is on. So a
/// plan is sound before it is good: a weaker rule costs time and is never wrong. The exception is
/// event-driven simulation, which is used only if its number of events is bounded.
///
/// The tolerance holds for the sum of all errors. Rules that can accept an error are applied in
/// this order, and each may spend what the earlier ones have left: the gyroscopic term, since
/// without it a formula may replace steps; bounces that are left out from event to event; late
/// hits; gravity; springs; bounces that steps leave out; sleep; float. Effects that are off without
/// an error stay proven: those proofs are about which bodies may meet, have friction or rotate, and
/// leaving out other effects adds none of these.
/// @param scene checked, as read_scene() returns it
/// @param options a step makes the run go step by step; overrides have the last word
/// @throws std::invalid_argument if the step is not finite and greater than 0, or if an override
/// names an effect that cannot be switched
Plan plan_scene(const Scene& scene, const PlanOptions& options = {});

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/plan.cpp"
#endif
