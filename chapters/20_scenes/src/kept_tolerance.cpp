#include <contact/scene/kept_tolerance.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <contact/plan/plan.hpp>
#include <contact/plan/plan_types.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/scene/scene_check.hpp>
#include <contact/scene/scene_run.hpp>

namespace contact {

namespace detail {

/// The part of a run that has no doubt yet.
class PartWithoutDoubt {
 public:
  PartWithoutDoubt(KeptTolerance& kept, const RunDoubts& doubts) : kept_(kept), doubts_(doubts) {}

  void end_at(double time, std::string why) {
    if (!(time < kept_.until)) return;
    kept_.until = std::max(time, 0.0);
    kept_.why = std::move(why);
  }
  void end_at(RunDoubt doubt, std::string why) { end_at(doubts_.since(doubt), std::move(why)); }

 private:
  KeptTolerance& kept_;
  const RunDoubts& doubts_;
};

CONTACT_SCENES_INLINE void end_where_plan_has_no_bound(const Plan& plan, PartWithoutDoubt& part) {
  if (std::isfinite(plan.error)) return;
  for (const Decision& decision : plan.decisions) {
    const Effect effect = decision.effect;
    if (has_no_bound(plan, decision))
      part.end_at(0, "without " + std::string(effect_name(effect)) +
                         ", which is forced off, the error has no bound");
    if (decision.on != decision.planned || std::isfinite(decision.error)) continue;
    if (effect == Effect::resting || effect == Effect::sleeping)
      part.end_at(RunDoubt::rest, decision.error_is);
    else if (effect != Effect::step_size && effect != Effect::penalty_contact)
      part.end_at(0, decision.error_is);
  }
}

}  // namespace detail

CONTACT_SCENES_INLINE KeptTolerance kept_tolerance(const Plan& plan, const SceneRun& run) {
  KeptTolerance kept;
  kept.asked = plan.tolerance;
  kept.until = kept.end = run.now();
  if (!(kept.asked > 0)) return kept;
  const RunDoubts doubts = run.counts().doubts;
  detail::PartWithoutDoubt part(kept, doubts);
  const auto charged = [&](Effect effect) {
    const double error = decision_on(plan, effect).error;
    return error > 0 && std::isfinite(error);
  };
  detail::end_where_plan_has_no_bound(plan, part);
  if (!charged(Effect::penalty_contact))
    part.end_at(RunDoubt::spring, "the error of the springs' substeps is not within the tolerance");
  if (!charged(Effect::step_size))
    part.end_at(RunDoubt::crowd,
                "impacts that bodies share are solved all at once; one after the other they may "
                "give another result");
  part.end_at(RunDoubt::varying,
              "a contact force varies within a step: on a curved surface, or on a body with "
              "vertices that rotates");
  part.end_at(RunDoubt::late_event, "a contact's force changes more often in a step than is found");
  part.end_at(RunDoubt::unsettled, "contacts were not solved to the tolerance");
  if (const auto fallback = run.fallback())
    part.end_at(fallback->time, "the run goes on step by step, because " + fallback->why);

  const Decision& horizon = decision_on(plan, Effect::horizon);
  const bool steps = !run.event_driven() && run.step() > 0 && !run.fallback();
  if (horizon.on && plan.pairs > 0) {
    const double hit = steps ? doubts.since(RunDoubt::hit) : 0;
    if (horizon.value)
      part.end_at(std::max(*horizon.value, hit),
                  "rounding errors may have grown to the tolerance, by an estimate");
    else
      part.end_at(hit, "no horizon is known: a hit may spread rounding errors");
  }
  const bool proven = !horizon.on && !(steps && doubts.since(RunDoubt::contact) < kept.until);
  kept.by = proven ? KeptBy::proof : KeptBy::estimate;
  if (!kept.whole() && !(kept.until > 0)) kept.by = KeptBy::nothing;
  return kept;
}

CONTACT_SCENES_INLINE std::string kept_by_text(KeptBy by) {
  switch (by) {
    case KeptBy::proof:
      return "proven";
    case KeptBy::estimate:
      return "estimated";
    case KeptBy::nothing:
      return "not known";
    default:
      return "not asked";
  }
}

CONTACT_SCENES_INLINE std::string kept_tolerance_text(const KeptTolerance& kept) {
  if (kept.by == KeptBy::not_asked) return "No tolerance of positions is asked for.";
  std::string text = "The tolerance of " + shortest_text(kept.asked) + " m: ";
  if (kept.by == KeptBy::nothing) return text + "not known to be kept: " + kept.why + ".";
  text += kept.whole() ? "kept in the whole run" : "kept up to " + shortest_text(kept.until) + " s";
  text += kept.by == KeptBy::proof ? ", proven" : ", by an estimate";
  return text + (kept.whole() ? "." : "; after that no bound: " + kept.why + ".");
}

}  // namespace contact
