#include <contact/plan/plan.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <contact/aabb.hpp>
#include <contact/ballistic.hpp>
#include <contact/broad_phase_cost.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/plan/plan_bounds.hpp>
#include <contact/plan/plan_costs.hpp>
#include <contact/plan/plan_hypotheses.hpp>
#include <contact/plan/plan_rules.hpp>
#include <contact/plan/plan_spreading.hpp>
#include <contact/plan/plan_types.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/scene/scene.hpp>
#include <contact/sphere_sphere_impact.hpp>
#include <contact/stepped/stepped_state.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// Applies an override to a decision.
CONTACT_SCENES_INLINE void override_decision(Decision& decision, const Overrides& overrides) {
  const bool with = is_listed(overrides.with, decision.effect);
  const bool without = is_listed(overrides.without, decision.effect);
  if (!with && !without) return;
  decision.overridden = true;
  decision.on = with;
}

/// Why the run is the same with an effect on and off: event-driven runs search for nothing between
/// steps, and do not simulate effects that hard, smooth balls lack; steps compute in double, with
/// every coordinate that is not proven constant.
/// @param on how the effect is switched
/// @return empty if the runs differ, or may
CONTACT_SCENES_INLINE std::string idle_reason(const Plan& plan, const Decision& decision, bool on) {
  if (plan.pairs == 0 || !can_be_switched(decision.effect)) return {};
  const bool events = decision_on(plan, Effect::event_driven).on;
  switch (decision.effect) {
    case Effect::double_precision:
      if (events || (decision.planned && !on)) return "every run with contacts computes in double";
      return {};
    case Effect::third_dimension:
    case Effect::second_dimension:
      if (events)
        return "from event to event, the run has the coordinates along which balls may move";
      return decision.planned && !on ? "steps compute each coordinate that may change" : "";
    case Effect::gravity:
      return events && on ? "from event to event, gravity acts wherever the scene has it" : "";
    case Effect::friction:
      return events && on ? "the coefficient of friction stays 0" : "";
    case Effect::restitution:
      return events && on ? "the coefficients of restitution stay as they are" : "";
    case Effect::event_driven:
      return {};
    case Effect::broad_phase:
      return events ? "from event to event, the number of balls chooses the search" : "";
    case Effect::continuous_detection:
      return events ? "from event to event, each impact is found in any case" : "";
    case Effect::rotation:
    case Effect::gyroscopic_term:
      return events ? "no torque acts on a smooth ball" : "";
    default:
      return events ? "from event to event there is no such stage" : "";
  }
}

/// Whether an override changes nothing in the run.
CONTACT_SCENES_INLINE bool is_idle(const Plan& plan, const Decision& switched) {
  return switched.overridden && !idle_reason(plan, switched, switched.on).empty();
}

CONTACT_SCENES_INLINE bool has_no_bound(const Plan& plan, const Decision& decision) {
  if (!decision.overridden || decision.on || !decision.planned) return false;
  if (is_idle(plan, decision)) return false;
  return decision.effect != Effect::sleeping && decision.effect != Effect::broad_phase &&
         decision.effect != Effect::event_driven;
}

/// The sum of the errors that decisions accept without an override. Each was taken from the rest of
/// the error budget, so the exact sum is at most the tolerance; but ∞ if one has no bound.
CONTACT_SCENES_INLINE double accepted_error(const Plan& plan) {
  std::vector<double> errors;
  for (const Decision& decision : plan.decisions) {
    if (has_no_bound(plan, decision)) return infinite;
    if (decision.on == decision.planned) errors.push_back(decision.error);
  }
  const double sum = sorted_sum(std::move(errors));
  return std::isfinite(sum) ? std::min(sum, plan.tolerance) : infinite;
}

/// A crowd's hits are processed only a few times a step, although detection is continuous: the
/// resulting displacement is an error of the step.
/// @param taken whether the same error is accepted already, by leaving out detection
CONTACT_SCENES_INLINE void charge_crowd(PlanInput& q, bool taken, Decision& step) {
  if (q.events || q.pairs.empty() || q.bounds.movers <= max_one_by_one) return;
  step.proven = false;
  step.because.push_back({"bodies that move", static_cast<double>(q.bounds.movers),
                          Relation::at_most, static_cast<double>(max_one_by_one),
                          "impacts taken one by one", ""});
  const double late = rounded_up(worst_bounces(q).late * q.step);
  step.error = taken || late <= q.tolerance_left ? late : infinite;
  step.error_is = "hits of a crowd, up to a step late";
  if (!taken) spend_tolerance(q, step);
}

/// When steps process impacts, one clause.
CONTACT_SCENES_INLINE std::string how_impacts_are_taken(const PlanInput& q, const Plan& plan) {
  if (q.bounds.movers > max_one_by_one) {
    return "more than " + std::to_string(max_one_by_one) +
           " bodies move, so impacts are taken at least " + std::to_string(crowd_substeps) +
           " times a step, all at once.";
  }
  bool edges = false;
  for (const SceneBody& body : q.scene->bodies)
    edges = edges || (body.moves && rotation_radius(body.shape) > 0);
  edges = edges && decision_on(plan, Effect::rotation).on;
  return "impacts are found between steps, up to " +
         std::to_string(max_impacts(q.bounds.movers, edges)) + " in each.";
}

CONTACT_SCENES_INLINE void add_notices(const PlanInput& q, Plan& plan) {
  const Decision& horizon = decision_on(plan, Effect::horizon);
  if (horizon.value && *horizon.value < q.scene->duration) {
    const std::string time = "t = " + short_number(*horizon.value) + " s";
    const bool bounded = std::isfinite(plan.error);
    const bool steps = !q.events && !decision_on(plan, Effect::step_size).proven;
    if (bounded && !steps)
      plan.notices.push_back("The tolerance holds up to about " + time + ", " +
                             (at_most_one_hit(q) ? "by a bound, as the two meet once"
                                                 : "by an estimate for typical hits, not a bound") +
                             "; after that only conserved quantities and statistics do.");
    else
      plan.notices.push_back(
          "After about " + time +
          ", by an estimate, only conserved quantities and statistics hold. "
          "Until when the tolerance holds is not known before the run, since " +
          (bounded ? "forces may vary within a step" : "an error that is accepted has no bound") +
          ": simulate tells it at the end.");
  }
  if (horizon.on && !horizon.value && q.bounds.movers > 0)
    plan.notices.push_back("Until when the tolerance holds is not known. " + horizon.why);
  const Decision& step = decision_on(plan, Effect::step_size);
  if (step.on && !step.proven && q.bounds.movers > 0) {
    plan.notices.push_back("Not proven that a step of " + short_number(q.step) +
                           " s keeps the tolerance; " + how_impacts_are_taken(q, plan));
  }
  if (plan.spring_substep > 0) {
    const double off = springs_off(q, plan.spring_substep);
    std::string notice =
        "Springs push in substeps of " + short_number(plan.spring_substep) + " s: ";
    if (!std::isfinite(off)) {
      notice += "no error is estimated for compliant contacts with friction or damping.";
    } else if (decision_on(plan, Effect::penalty_contact).error > 0) {
      notice += "by an estimate that keeps the tolerance; it is not proven.";
    } else {
      notice +=
          "by an estimate that leaves " + short_number(off) + " m at the end" +
          (q.tolerance > 0 ? "; to keep the tolerance would take more than 1024 substeps a step."
                           : ", and no error is accepted.");
    }
    plan.notices.push_back(std::move(notice));
  }
  if (q.events && decision_on(plan, Effect::several_contacts).on) {
    plan.notices.push_back(
        "Hits at the same instant are processed one after the other; which one comes first then "
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
        "Event-driven is forced on, but a scene that is not one of hard, smooth balls still goes "
        "step by step.");
  }
  for (const Decision& decision : plan.decisions) {
    if (!has_no_bound(plan, decision)) continue;
    plan.notices.push_back("Without " + std::string(effect_name(decision.effect)) +
                           " the error has no bound: the plan has it on.");
  }
}

}  // namespace detail

// [plan]
CONTACT_SCENES_INLINE Plan plan_scene(const Scene& scene, const PlanOptions& options) {
  if (options.step && !(std::isfinite(*options.step) && *options.step > 0))
    throw_invalid_argument("step", number_text(*options.step), "must be finite and greater than 0");
  for (const auto& list : {options.overrides.with, options.overrides.without}) {
    for (const Effect effect : list) {
      if (!can_be_switched(effect))
        throw_invalid_argument("effect", std::string(effect_name(effect)),
                               "is a value; it is not switched on or off");
    }
  }
  for (const std::string& id : options.dropped) proof_hypothesis(id);
  PlanInput q = plan_input(scene, options.dropped);
  Plan plan;
  plan.tolerance = q.tolerance;
  plan.decisions.resize(all_effects.size());
  const auto decided = [&](Effect effect) -> Decision& {
    return plan.decisions[static_cast<std::size_t>(effect)];
  };
  const auto decide_on = [&](Decision decision) {
    const Effect effect = decision.effect;
    spend_tolerance(q, decision);
    decided(effect) = std::move(decision);
    if (effect != Effect::event_driven)
      detail::override_decision(decided(effect), options.overrides);
  };

  decide_on(plan_gyroscopic_term(q));
  q.constant_rotation = !decided(Effect::gyroscopic_term).planned;
  Decision event_driven = plan_event_driven(q);
  const bool steps_asked = options.step.has_value();
  if (steps_asked) {
    event_driven.on = event_driven.planned = false;
    event_driven.why = "A step is asked for, so the run goes step by step.";
    event_driven.because.clear();
  }
  detail::override_decision(event_driven, options.overrides);
  q.events = event_driven.on;
  if (!q.events) {
    event_driven.error = 0;
    event_driven.error_is = "none";
  }
  // Of its proofs, only that of bounces that are left out has an error.
  if (event_driven.error > 0) plan.cutoff = contact_time_cutoff(q.tolerance_left, q.bounds.gravity);
  decide_on(std::move(event_driven));
  if (!q.events) q.step = steps_asked ? *options.step : step_from_tolerance(q);
  decide_on(plan_step_size(q, options));
  decide_on(plan_continuous_detection(q, q.step));
  const Decision& looking = decided(Effect::continuous_detection);
  if (looking.on) detail::charge_crowd(q, !looking.planned, decided(Effect::step_size));
  decide_on(plan_gravity(q));
  plan.spring_substep = longest_spring_substep(q);
  decide_on(plan_penalty_contact(q));
  // Half the cutoff up, half of it down: a run in steps treats the same bounces alike.
  plan.rest_height = q.bounds.gravity * plan.cutoff * plan.cutoff / 8;
  Decision resting = plan_resting(q);
  if (!q.events && resting.planned) plan.rest_height = max_skipped_bounce(q);
  decide_on(std::move(resting));
  Decision sleeping = plan_sleeping(q);
  plan.sleep_speed = sleep_speed(q, sleeping);
  decide_on(std::move(sleeping));
  decide_on(plan_double_precision(q));

  decide_on(plan_rotation(q));
  decide_on(plan_friction(q));
  decide_on(plan_restitution(q));
  decide_on(plan_broad_phase(q));
  decide_on(plan_several_contacts(q));
  decide_on(plan_third_dimension(q));
  decide_on(plan_second_dimension(q));
  decide_on(plan_horizon(q, decided(Effect::rotation).planned));
  plan.speed = q.bounds.speed;
  plan.step = q.step;
  plan.pairs = static_cast<std::size_t>(pairs_that_may_meet(q.bounds));
  plan.error = detail::accepted_error(plan);
  estimate_savings(q, q.events ? detail::frame_step(scene) : q.step, plan);
  for (Decision& decision : plan.decisions) {
    const bool switched = decision.overridden ? decision.on : !decision.on;
    decision.changes_nothing = detail::idle_reason(plan, decision, switched);
  }
  detail::add_notices(q, plan);
  return plan;
}
// [/plan]

}  // namespace contact
