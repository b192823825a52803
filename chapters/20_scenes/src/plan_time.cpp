#include <contact/plan/plan_rules.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <contact/plan/plan_bounds.hpp>
#include <contact/plan/plan_spreading.hpp>
#include <contact/plan/plan_types.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/scene/scene.hpp>
#include <contact/vector.hpp>

namespace contact {

CONTACT_SCENES_INLINE Inequality rotation_is_constant(const PlanInput& q) {
  return {"kinds of rotation that a gyroscopic term may change",
          q.constant_rotation ? 0.0 : 1.0,
          Relation::equal,
          0,
          "none",
          ""};
}

CONTACT_SCENES_INLINE std::vector<Inequality> event_conditions(const PlanInput& q) {
  double still = 0;
  double soft = 0;
  for (const PairBound& pair : q.pairs) {
    soft += pair.soft ? pair.count : 0;
    still += !pair.both_move && !pair.half_space && !is_ball(q.scene->bodies[pair.b]) ? 1 : 0;
  }
  return {{"moving bodies other than balls that may touch something", touching_non_balls(q),
           Relation::equal, 0, "none", ""},
          {"fixed bodies that may be touched, other than half-spaces and balls", still,
           Relation::equal, 0, "none", ""},
          {"pairs that may meet and are compliant", soft, Relation::equal, 0, "none", ""},
          {"largest friction between bodies that may meet",
           proven_line(q) ? 0.0 : max_friction(q.pairs), Relation::equal, 0, "smooth", ""},
          rotation_is_constant(q)};
}

// [event-rule]
CONTACT_SCENES_INLINE Decision plan_event_driven(const PlanInput& q) {
  const std::vector<Inequality> common = event_conditions(q);
  const auto with = [&](std::string why, const std::vector<Inequality>& more) {
    Proof proof{std::move(why), common};
    proof.conditions.insert(proof.conditions.end(), more.begin(), more.end());
    return proof;
  };
  const bool lonely = max_partners(q) <= 1;
  double lossy = 0;
  double touching = 0;
  for (const PairBound& pair : q.pairs) {
    lossy = std::max(lossy, pair.hard ? 1 - pair.min_restitution : 0.0);
    touching += pair.apart || lonely ? 0 : 1;
  }
  const Inequality elastic{"largest loss of speed, 1 − e, between bodies that may meet",
                           lossy,
                           Relation::equal,
                           0,
                           "elastic",
                           ""};
  // Touching bodies pass a hit on at the same instant, but events come one after the other.
  const Inequality clear{"kinds of pairs that touch at the beginning beside others",
                         touching,
                         Relation::equal,
                         0,
                         "none",
                         ""};
  // The conditions that all proofs here have already are left out: no friction and no springs.
  const auto add_rest = [](const Proof& rest, std::vector<Inequality>& more) {
    for (const Inequality& condition : rest.conditions) {
      if (!condition.hypothesis.ends_with("/no-springs") &&
          condition.hypothesis != "elastic-balls/smooth-beside-others")
        more.push_back(condition);
    }
  };
  std::vector<Proof> proofs;
  for (const Proof& rest : resting_proofs(q)) {
    if (!is_proven(rest)) continue;
    std::vector<Inequality> more{elastic, clear};
    add_rest(rest, more);
    proofs.push_back(
        with("Elastic balls that never rest have finitely many hits in a finite time.", more));
    break;
  }
  if (proofs.empty()) {
    std::vector<Inequality> more{elastic, clear};
    const std::vector<Proof> rest = resting_proofs(q);
    add_rest(rest[2], more);
    proofs.push_back(
        with("Elastic balls that never rest have finitely many hits in a finite time.", more));
  }
  const BounceRange bounces = worst_bounces(q);
  proofs.push_back(with("Every ball has a bounded number of impacts.",
                        {{"most impacts of one ball", bounces.hits, Relation::less, 1e6,
                          "as many as a run may take for one ball", ""}}));
  // A bounce that is left out: each ball on one hard half-space, pressed on by gravity.
  double other = 0;
  for (const PairBound& pair : q.pairs) other += pair.half_space && !pair.soft ? 0 : pair.count;
  const double cutoff =
      gravity_felt(q) > 0 ? contact_time_cutoff(q.tolerance_left, q.bounds.gravity) : 0;
  const double bounce = detail::rounded_up(q.bounds.gravity * cutoff * cutoff / 8);
  Proof short_bounces = with(
      "A ball on one half-space is followed until its bounces are shorter than " +
          number_text(static_cast<double>(static_cast<float>(cutoff))) + " s; after that it rests.",
      {{"most bodies that one moving body may touch", max_partners(q), Relation::at_most, 1,
        "one half-space", ""},
       {"pairs that may meet other than a ball and a hard half-space", other, Relation::equal, 0,
        "none", ""},
       {"a bounce of no height", 0, Relation::less, bounce, "height of a bounce that is left out",
        "m"},
       fits_tolerance(q, "height of a bounce that is left out, g t²/8", bounce)});
  short_bounces.error = bounce;
  short_bounces.error_is = "height of the bounces that are left out, g t²/8";
  proofs.push_back(std::move(short_bounces));

  Decision decision = decide(Effect::event_driven, std::move(proofs),
                             "Not proven that the number of events is bounded: step by step.");
  // This rule's proofs switch the effect on.
  decision.on = decision.planned = decision.proven;
  if (!decision.on && touching > 0 && hits_at_once(q) > 0)
    decision.why +=
        " From event to event bodies that touch are hit one after the other, in an order that the "
        "scene does not give; steps find one impulse for all of them at once.";
  return decision;
}
// [/event-rule]

// [step-rule]
CONTACT_SCENES_INLINE double step_from_tolerance(const PlanInput& q) {
  double h = detail::frame_step(*q.scene);
  if (pairs_that_may_meet(q.bounds) == 0) return h;
  const double spring = detail::fastest_spring(q);
  if (spring > 0) h = std::min(h, 1 / (10 * spring));
  const BounceRange bounces = worst_bounces(q);
  if (!(q.tolerance_left > 0) || !std::isfinite(bounces.late) || bounces.late == 0) return h;
  double shorter = std::min(h, detail::rounded_down(q.tolerance_left / bounces.late, 256));
  for (int k = 0; k < 40; ++k, shorter /= 2) {
    bool all = true;
    if (shorter < h / 1024) break;
    for (const Inequality& condition : tunnelling_conditions(q, shorter))
      all = all && holds(condition);
    if (all) return shorter;
  }
  return h;
}

CONTACT_SCENES_INLINE Decision plan_step_size(const PlanInput& q, const PlanOptions& options) {
  Decision decision;
  decision.effect = Effect::step_size;
  if (q.events) {
    decision.on = decision.planned = false;
    decision.proven = true;
    decision.why = "From event to event there are no steps.";
    decision.because = {{"steps between two impacts", 0, Relation::equal, 0, "none", ""}};
    return decision;
  }
  decision.value = q.step;
  const double spring = detail::fastest_spring(q);
  decision.why =
      options.step ? "The step is the one asked for." : "The step follows from the tolerance.";
  // What a step would miss without detection between steps: its failed conditions, and first the
  // error that it makes.
  if (!q.pairs.empty()) {
    const std::vector<Inequality> missed = tunnelling_conditions(q, q.step);
    for (std::size_t k = 0; k < missed.size(); ++k)
      if (k == 1 || !holds(missed[k])) decision.because.push_back(missed[k]);
  }
  if (spring > 0)
    decision.because.push_back({"step times the stiffest spring's angular frequency",
                                q.step * spring, Relation::less, 2,
                                "stability limit of semi-implicit Euler", ""});
  decision.proven = !decision.because.empty();
  for (const Inequality& condition : decision.because)
    decision.proven = decision.proven && holds(condition);
  if (q.pairs.empty()) {
    decision.proven = true;
    decision.why = q.constant_rotation
                       ? "Nothing touches anything and flights are exact, so any step does."
                       : "Nothing touches anything and flights are exact, so any step does; it is "
                         "divided into as many substeps as the rotation needs.";
  }
  if (!decision.proven && !options.step)
    decision.why =
        "Not proven that a step keeps the tolerance: it is a frame, and impacts in it are searched "
        "for.";
  return decision;
}
// [/step-rule]

// [precision-rule]
CONTACT_SCENES_INLINE Decision plan_double_precision(const PlanInput& q) {
  const Scene& scene = *q.scene;
  const double t = scene.duration;
  double size = 0;
  double turning = 0;
  // Numbers whose squares overflow in float, and a tolerance below the squares that underflow.
  const auto beyond = [](double x) { return x > 0x1p60 ? 1.0 : 0.0; };
  double unfit = beyond(t) + beyond(q.bounds.gravity) + (q.tolerance_left < 0x1p-80 ? 1 : 0);
  for (const SceneBody& body : scene.bodies) {
    if (!body.moves) continue;
    unfit += beyond(body.angular_velocity.norm());
    for (int k = 0; k < 3; ++k) {
      // The input is rounded too, so each factor is wrong by u before anything is computed.
      size = std::max(size, std::abs(body.position(k)) + std::abs(body.velocity(k)) * t +
                                std::abs(scene.gravity(k)) * t * t / 2);
    }
    if (!body.angular_velocity.isZero(0))
      turning =
          std::max(turning, rotation_radius(body.shape) * (1 + body.angular_velocity.norm() * t));
  }
  const double rounding =
      detail::rounded_up(tolerance::unit_roundoff<float> * (16 * size + 32 * turning));
  return decide(Effect::double_precision,
                {{"The only error of a free flight in float is rounding.",
                  {nothing_meets(q),
                   fits_tolerance(q, "rounding error of a flight in float", rounding),
                   rotation_is_constant(q),
                   {"numbers whose squares overflow or underflow in float", unfit, Relation::equal,
                    0, "none", ""}},
                  rounding,
                  "rounding in float"}},
                "Not proven that float keeps the tolerance: a hit may amplify rounding errors.");
}
// [/precision-rule]

}  // namespace contact
