/// @file
/// The planner: decides of each effect whether it can matter in a scene, before the scene runs.
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

/// A number for a sentence: four digits.
inline std::string short_number(double x) {
  char text[48];
  std::snprintf(text, sizeof text, "%.4g", x);
  return text;
}

}  // namespace detail

/// The plan of a scene.
///
/// What is off is off by a proof or a bound; what no rule can prove is on. So a plan is sound
/// before it is good: a weaker rule costs time and is never wrong. The exception is the run from
/// event to event, which is taken only if its number of events is bounded.
///
/// The tolerance holds for all errors together. Rules that can accept one are asked in this order,
/// and each may take from what is left: the gyroscopic term, since without it a formula may do for
/// steps; hops that are left out from event to event; late hits; gravity; springs; hops that steps
/// leave out; sleep; float. What is off without an error stays proven beside what is off with one:
/// those proofs are of what may meet, rub or turn, and what is left out with an error makes nothing
/// of that more.
/// @param scene checked, as read_scene() gives it
/// @param options a step makes the run go step by step; overrides have the last word
/// @throws std::invalid_argument if the step is not finite and greater than 0, or if an override
/// names an effect that cannot be switched
Plan plan_scene(const Scene& scene, const PlanOptions& options = {});

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/plan.cpp"
#endif
