#include <contact/plan/plan_rules.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include <contact/inertia.hpp>
#include <contact/plan/plan_bounds.hpp>
#include <contact/plan/plan_costs.hpp>
#include <contact/plan/plan_types.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/stepped/stepped_state.hpp>

namespace contact {

// [savings]
/// Sums up an estimate, with its terms in words: "25 for each body and substep (1200)".
class Tally {
 public:
  /// Adds a number of things.
  /// @param each instructions for one of them
  /// @param of name of one of them
  /// @param count expected number
  Tally& add(double each, std::string_view of, double count) {
    const double product = each * count;
    if (!std::isfinite(product) || product == 0) return *this;
    saving_.instructions += product;
    if (!saving_.is.empty()) saving_.is += ", ";
    saving_.is += digits(each) + " for each " + std::string(of) + " (" + digits(count) + ")";
    return *this;
  }
  /// The sum, and its words.
  /// @param nothing what to say if the sum is empty
  Saving saving(std::string_view nothing = "nothing") const {
    return saving_.is.empty() ? Saving{0, std::string(nothing)} : saving_;
  }

  /// A number for a sentence.
  static std::string digits(double x) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), std::abs(x) < 1e6 ? "%.0f" : "%.2g", x);
    return text.data();
  }

 private:
  Saving saving_;
};

namespace detail {

/// The number of balls and walls tested after impacts, from event to event. A ball's neighbours are
/// in its cell and those around it, 27.
CONTACT_SCENES_INLINE double asked_after_hits(const ExpectedRun& run) {
  return run.cells ? 2 * run.hits * (27 * run.occupancy + run.walls)
                   : (2 * run.hits - run.wall_hits) * (run.bounded - 1 + run.walls);
}

/// The cost of an event-driven run.
CONTACT_SCENES_INLINE Saving events_cost(const ExpectedRun& run) {
  Tally sum;
  sum.add(cost::hit, "impact", run.hits);
  sum.add(cost::prediction, "ball or wall tested after a hit", asked_after_hits(run));
  if (run.cells) sum.add(cost::crossing, "crossing from cell to cell", run.crossings);
  return sum.saving();
}

/// The cost of a run in steps: of each substep, and what is in it.
CONTACT_SCENES_INLINE Saving steps_cost(const PlanInput& q, const ExpectedRun& run, bool turns,
                                        bool gyroscopic_substeps) {
  const double moved = run.substeps * run.movers;
  Tally sum;
  if (pairs_that_may_meet(q.bounds) == 0) {
    sum.add(cost::placed, "step", run.steps);
  } else {
    sum.add(cost::substep, "substep", run.substeps);
    sum.add(cost::swept_box, "body's box", run.bounded * run.substeps);
    sum.add(std::min(run.search.all, run.search.cells), "search for pairs", run.substeps);
  }
  sum.add(cost::motion, "body moved", moved);
  if (gravity_felt(q) > 0) sum.add(cost::gravity, "body that falls", moved);
  if (gyroscopic_substeps)
    sum.add(cost::gyroscopic_substep, "substep of a rotation", run.gyroscopic_substeps);
  else if (turns)
    sum.add(cost::rotation, "body rotated", moved);
  sum.add(cost::contact, "contact and substep", run.contacts * run.substeps * run.awake);
  if (run.touching > 0)
    sum.add(run.gaps / run.touching, "pair that touches", run.touching * run.substeps * run.awake);
  sum.add(cost::contact + 2 * (cost::sphere_gap + cost::sphere_impact), "impact", run.hits);
  return sum.saving();
}

inline constexpr std::string_view brought_along =
    "nothing: the gyroscopic term, which is on, includes it";

/// The cost of effects where nothing may meet.
CONTACT_SCENES_INLINE Saving flight_saving(const PlanInput& q, const ExpectedRun& run,
                                           Effect effect, bool turns, bool gyroscopic_substeps) {
  const double moved = run.substeps * run.movers;
  const std::string formula = "nothing: a position is a formula, computed on request";
  switch (effect) {
    case Effect::gravity:
      return q.events ? Saving{0, formula}
                      : Tally().add(cost::gravity, "body and step", moved + run.substeps).saving();
    case Effect::rotation:
      if (!q.events && gyroscopic_substeps) return {0, std::string(brought_along)};
      return q.events ? Saving{0, formula}
                      : Tally().add(cost::rotation, "body and step", moved).saving();
    case Effect::gyroscopic_term: {
      if (!turns) return {0, "nothing, where nothing rotates"};
      if (!q.events)
        return Tally()
            .add(cost::gyroscopic_substep, "substep of a rotation", run.gyroscopic_substeps)
            .saving();
      const Saving steps = steps_cost(q, run, true, true);
      return {steps.instructions, "no formula has it, and steps take " + steps.is};
    }
    case Effect::event_driven: {
      if (!q.events) return {0, "nothing: a body whose angular velocity changes has no formula"};
      const Saving steps = steps_cost(q, run, turns, false);
      return {-steps.instructions, "a formula, in place of " + steps.is};
    }
    default:
      return {0, "nothing: where nothing can meet there is no such stage"};
  }
}

/// Whether the scene is one of hard, smooth balls, so that it can be event-driven.
CONTACT_SCENES_INLINE bool has_events_alone(const PlanInput& q) {
  const std::vector<Inequality> conditions = event_conditions(q);
  return std::all_of(conditions.begin(), conditions.end(), holds);
}

CONTACT_SCENES_INLINE Saving events_in_place_of_steps(const PlanInput& q, ExpectedRun run,
                                                      bool turns) {
  run.cells = run.bounded > double{cost::max_balls_without_cells};
  const Saving steps = steps_cost(q, run, turns, false);
  const Saving events = events_cost(run);
  return {events.instructions - steps.instructions, events.is + "; in place of " + steps.is};
}

/// The cost of effects from event to event.
CONTACT_SCENES_INLINE Saving event_saving(const PlanInput& q, const ExpectedRun& run,
                                          const Plan& plan, Effect effect) {
  const auto share = [&](double of_asked, double of_crossings) {
    Tally sum;
    sum.add(cost::hit * of_asked, "impact", run.hits);
    sum.add(cost::prediction * of_asked, "ball or wall tested after a hit", asked_after_hits(run));
    if (run.cells)
      sum.add(cost::crossing * of_crossings, "crossing from cell to cell", run.crossings);
    return sum.saving();
  };
  switch (effect) {
    case Effect::gravity:
      return share(cost::prediction_in_gravity, cost::crossing_in_gravity);
    case Effect::third_dimension:
    case Effect::second_dimension: {
      const bool two =
          effect == Effect::third_dimension && !decision_on(plan, Effect::second_dimension).planned;
      const double axes = two ? 2 : 1;
      return share(axes * cost::prediction_in_coordinate, axes * cost::prediction_in_coordinate);
    }
    case Effect::broad_phase: {
      ExpectedRun other = run;
      other.cells = !run.cells;
      const double cells = (run.cells ? events_cost(run) : events_cost(other)).instructions;
      const double all = (run.cells ? events_cost(other) : events_cost(run)).instructions;
      return {cells - all, "in cells, instead of testing all others after " +
                               Tally::digits(run.hits) + " impacts"};
    }
    case Effect::event_driven:
      return events_in_place_of_steps(q, run, false);
    case Effect::restitution:
      return {0, "nothing: a hit without rebound takes as long"};
    case Effect::continuous_detection:
      return {0, "nothing: from event to event each impact is found in any case"};
    case Effect::several_contacts:
      return {0, "nothing: hits are taken one after the other"};
    default:
      return {0, "nothing: from event to event there is no such stage"};
  }
}

/// The cost of effects in steps where bodies may meet.
CONTACT_SCENES_INLINE Saving step_saving(const PlanInput& q, const ExpectedRun& run,
                                         const Plan& plan, Effect effect) {
  const auto planned = [&](Effect one) { return decision_on(plan, one).planned; };
  const double moved = run.substeps * run.movers * run.awake;
  const double points = run.contacts * run.substeps * run.awake;
  const double pairs = run.touching * run.substeps * run.awake;
  Tally sum;
  switch (effect) {
    case Effect::gravity:
      sum.add(cost::gravity, "body and substep", moved + run.substeps);
      if (planned(effect)) sum.add(cost::pressed, "contact and substep", points);
      return sum.saving();
    case Effect::rotation:
      if (planned(Effect::gyroscopic_term)) return {0, std::string(brought_along)};
      if (!planned(effect))
        return sum.add(cost::rotation_at_rest, "body and substep", moved)
            .add(cost::idle_rotating_contact, "contact and substep", points)
            .saving();
      return sum.add(cost::rotation, "body and substep", moved)
          .add(cost::rotating_contact, "contact and substep", points)
          .saving();
    case Effect::gyroscopic_term:
      if (!planned(Effect::rotation)) {
        sum.add(cost::rotation_at_rest, "body and substep", moved);
        return sum.add(cost::idle_rotating_contact, "contact and substep", points).saving();
      }
      return sum.add(cost::gyroscopic_substep, "substep of a rotation", run.gyroscopic_substeps)
          .add(cost::gyroscopic_check, "body and substep", moved)
          .saving();
    case Effect::friction:
      if (max_friction(q.pairs) == 0)
        return {0, "nothing: a coefficient of 0 is a number, and no stage"};
      return sum.add(cost::friction, "contact and substep", points)
          .add(cost::friction, "impact", run.hits)
          .saving("nothing: no contact is known to last");
    case Effect::restitution:
      sum.add(cost::bounce_stages, "substep", run.substeps);
      if (q.bounds.movers > max_one_by_one) sum.add(cost::contact, "impact", run.hits);
      return sum.saving();
    case Effect::continuous_detection:
      sum.add(cost::impact_search, "substep", run.substeps)
          .add(cost::wide_gap, "pair that touches", pairs + run.spring_substeps);
      if (q.bounds.movers > max_one_by_one) return sum.saving();
      sum.add(2 * run.impact, "impact", run.hits)
          .add(run.impact, "substep and pair that nothing presses", run.unpressed * run.substeps);
      return planned(Effect::rotation) && touching_non_balls(q) > 0
                 ? sum.saving().and_more(
                       "more where vertices rotate near other bodies, which is not known before")
                 : sum.saving();
    case Effect::broad_phase:
      return sum
          .add(run.search.cells - run.search.all, "substep, in cells instead of all pairs",
               run.substeps)
          .saving();
    case Effect::several_contacts:
      if (!(points > 0)) return {0, "nothing: no contact is known to last"};
      return sum.add(cost::exact_solve, "contact and substep", points)
          .saving()
          .and_more(
              "the exact solve of residuals costs more or saves iterations, which is not known "
              "before");
    case Effect::resting:
      return {0, "nothing: what stops an approach is there without it"};
    case Effect::sleeping: {
      sum.add(cost::sleep_stage, "substep", run.substeps)
          .add(cost::sleep, "body and substep", moved);
      Saving saving = sum.saving();
      if (run.awake < 1) {
        const double asleep = run.substeps * (1 - run.awake);
        const double saved =
            asleep * (run.contacts * cost::contact + run.gaps + run.movers * cost::motion);
        saving.instructions -= saved;
        saving.is += "; less for bodies that sleep from the beginning, which are skipped";
      }
      return saving;
    }
    case Effect::penalty_contact:
      sum.add(cost::spring_stage, "substep", run.substeps);
      return sum
          .add(cost::spring + cost::substep + cost::sphere_gap + cost::motion * run.movers +
                   cost::swept_box * run.bounded,
               "substep in which a spring pushes", run.spring_substeps)
          .saving();
    case Effect::third_dimension:
    case Effect::second_dimension: {
      if (planned(effect))
        return {0, "nothing: steps compute each coordinate that is not proven constant"};
      const bool two = effect == Effect::third_dimension && !planned(Effect::second_dimension);
      // A rotating body has two more coordinates of angular velocity.
      const double axes = (two ? 2 : 1) + (planned(Effect::rotation) ? 2 : 0);
      return sum.add(axes * cost::coordinate, "body and substep", moved)
          .add(axes * cost::contact_coordinate, "contact and substep", points + run.spring_substeps)
          .saving();
    }
    case Effect::event_driven:
      if (!has_events_alone(q))
        return {0, "nothing: a scene not of hard, smooth balls goes step by step in any case"};
      return events_in_place_of_steps(q, run, planned(Effect::rotation));
    default:
      return {0, "nothing"};
  }
}

}  // namespace detail

CONTACT_SCENES_INLINE void estimate_savings(const PlanInput& q, double h, Plan& plan) {
  const bool turns = decision_on(plan, Effect::rotation).planned;
  const bool gyroscopic_substeps = decision_on(plan, Effect::gyroscopic_term).planned;
  const bool free = pairs_that_may_meet(q.bounds) == 0;
  const bool events = q.events && (free || detail::has_events_alone(q));
  ExpectedRun run =
      expected_run(q, h, plan.spring_substep, decision_on(plan, Effect::sleeping).planned);
  run.cells = events && decision_on(plan, Effect::broad_phase).planned;
  for (Decision& decision : plan.decisions) {
    const Effect effect = decision.effect;
    if (!can_be_switched(effect)) continue;
    const bool axis = effect == Effect::third_dimension || effect == Effect::second_dimension;
    Saving& saving = decision.saving;
    if (effect == Effect::double_precision)
      saving = {0, free ? "half the memory of every number"
                        : "nothing: no run but a free flight is in float"};
    else if (free && (events || !axis))
      saving = axis ? Saving{0, "nothing but memory"}
                    : detail::flight_saving(q, run, effect, turns, gyroscopic_substeps);
    else
      saving = events ? detail::event_saving(q, run, plan, effect)
                      : detail::step_saving(q, run, plan, effect);
    if (effect == Effect::rotation && saving.instructions > 0)
      saving = saving.and_more("7 numbers a body");
    if (axis && (free || saving.instructions > 0)) saving = saving.and_more("2 numbers a body");
    const bool guessed = saving.is.find("contact and substep") != std::string::npos ||
                         saving.is.find("pair that touches") != std::string::npos;
    if (run.heap && guessed) saving = saving.and_more("assuming three contacts a body in a heap");
  }
}
// [/savings]

}  // namespace contact
