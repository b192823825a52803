/// @file
/// The planner: decides of each effect whether it can matter in a scene, before the scene runs.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <contact/invalid_argument.hpp>
#include <contact/plan_bounds.hpp>
#include <contact/plan_contact.hpp>
#include <contact/plan_motion.hpp>
#include <contact/plan_time.hpp>
#include <contact/plan_types.hpp>
#include <contact/scene.hpp>

namespace contact {

namespace detail {

inline bool is_listed(const std::vector<Effect>& effects, Effect effect) {
  return std::find(effects.begin(), effects.end(), effect) != effects.end();
}

/// Gives a decision the last word that somebody wants to have.
inline void override_decision(Decision& decision, const Overrides& overrides) {
  const bool with = is_listed(overrides.with, decision.effect);
  const bool without = is_listed(overrides.without, decision.effect);
  if (!with && !without) return;
  decision.overridden = true;
  decision.on = with;
}

/// A number for a sentence: four digits.
inline std::string short_number(double x) {
  char text[48];
  std::snprintf(text, sizeof text, "%.4g", x);
  return text;
}

/// Whether a switch that somebody set changes nothing in the run: from event to event nothing is
/// looked for between steps, and what a hard, smooth ball does not have is not simulated; steps
/// compute in double, with every coordinate that is not proven to stay.
inline bool is_idle(const Plan& plan, const Decision& switched) {
  if (!switched.overridden || plan.pairs == 0) return false;
  switch (switched.effect) {
    case Effect::double_precision:
    case Effect::third_dimension:
    case Effect::second_dimension:
      return decision_on(plan, Effect::event_driven).on || (switched.planned && !switched.on);
    case Effect::gravity:
    case Effect::friction:
    case Effect::restitution:
      return decision_on(plan, Effect::event_driven).on && switched.on;
    case Effect::event_driven:
      return false;
    default:
      return decision_on(plan, Effect::event_driven).on;
  }
}

inline void add_notices(const PlanQuestion& q, Plan& plan) {
  const Decision& horizon = decision_on(plan, Effect::horizon);
  if (horizon.value && *horizon.value < q.scene->duration) {
    plan.notices.push_back("The tolerance holds up to about t = " + short_number(*horizon.value) +
                           " s, by an estimate for bodies spread evenly; after that only conserved "
                           "quantities and statistics do.");
  }
  const Decision& step = decision_on(plan, Effect::step_size);
  if (step.on && !step.proven && q.bounds.movers > 0) {
    plan.notices.push_back("Not proven that a step of " + short_number(q.step) +
                           " s keeps the tolerance; impacts are found between steps.");
  }
  if (q.events && decision_on(plan, Effect::several_contacts).on) {
    plan.notices.push_back(
        "Hits that fall on one instant are taken one after the other; which comes first then "
        "decides.");
  }
  std::string idle;
  for (const Decision& decision : plan.decisions) {
    if (!is_idle(plan, decision)) continue;
    idle += (idle.empty() ? "" : ", ") + std::string(effect_name(decision.effect));
  }
  if (!idle.empty()) {
    plan.notices.push_back(
        "Forced, but changes nothing in this run: " + idle +
        (decision_on(plan, Effect::event_driven).on ? ". Without event-driven it may." : "."));
  }
  const Decision& events = decision_on(plan, Effect::event_driven);
  if (events.overridden && events.on && !events.planned) {
    plan.notices.push_back(
        "Event-driven is forced on; a scene that is not one of hard, smooth balls goes step by "
        "step all the same.");
  }
  for (const Decision& decision : plan.decisions) {
    if (!decision.overridden || decision.on == decision.planned || decision.on) continue;
    if (is_idle(plan, decision)) continue;
    if (decision.effect == Effect::sleeping || decision.effect == Effect::broad_phase) continue;
    plan.notices.push_back("Without " + std::string(effect_name(decision.effect)) +
                           " the error has no bound: the plan has it on.");
  }
}

}  // namespace detail

// [plan]
/// The plan of a scene.
///
/// What is off is off by a proof or a bound; what no rule can prove is on. So a plan is sound
/// before it is good: a weaker rule costs time and is never wrong. The exception is the run from
/// event to event, which is taken only if its number of events is bounded.
/// @param scene checked, as read_scene() gives it
/// @param options a step makes the run go step by step; overrides have the last word
/// @throws std::invalid_argument if the step is not finite and greater than 0, or if an override
/// names an effect that cannot be switched
inline Plan plan_scene(const Scene& scene, const PlanOptions& options = {}) {
  if (options.step && !(std::isfinite(*options.step) && *options.step > 0))
    throw_invalid_argument("step", number_text(*options.step), "must be finite and greater than 0");
  for (const auto& list : {options.overrides.with, options.overrides.without}) {
    for (const Effect effect : list) {
      if (!can_be_switched(effect))
        throw_invalid_argument("effect", std::string(effect_name(effect)),
                               "is a value; it is not switched on or off");
    }
  }
  PlanQuestion q = plan_question(scene);

  q.even_spins = !plan_gyroscopic_term(q).planned;
  Plan plan;
  Decision event_driven = plan_event_driven(q);
  // Of its proofs only that of hops which are left out has an error.
  if (event_driven.proven && event_driven.error > 0)
    plan.cutoff = contact_time_cutoff(q.tolerance, q.bounds.gravity);
  if (options.step) {
    event_driven.on = event_driven.planned = false;
    event_driven.why = "A step is asked for, so the run goes step by step.";
    event_driven.because.clear();
    event_driven.error = 0;
    event_driven.error_is = "none";
  }
  detail::override_decision(event_driven, options.overrides);
  q.events = event_driven.on;
  q.hits = expected_hits(q);
  if (!q.events) q.step = options.step ? *options.step : step_from_tolerance(q);
  const auto movers = static_cast<double>(q.bounds.movers);
  q.moves = q.events ? movers + 2 * q.hits : movers * std::ceil(scene.duration / q.step);

  plan.decisions = {plan_gravity(q),          plan_rotation(q),
                    plan_gyroscopic_term(q),  plan_friction(q),
                    plan_restitution(q),      plan_continuous_detection(q, q.step),
                    plan_broad_phase(q),      plan_several_contacts(q),
                    plan_resting(q),          plan_sleeping(q),
                    plan_penalty_contact(q),  plan_third_dimension(q),
                    plan_second_dimension(q), plan_double_precision(q),
                    std::move(event_driven),  plan_step_size(q, options),
                    plan_horizon(q)};
  for (Decision& decision : plan.decisions) {
    if (decision.effect != Effect::event_driven)
      detail::override_decision(decision, options.overrides);
  }
  plan.speed = q.bounds.speed;
  plan.step = q.step;
  plan.pairs = static_cast<std::size_t>(pairs_that_may_meet(q.bounds));
  detail::add_notices(q, plan);
  return plan;
}
// [/plan]

}  // namespace contact
