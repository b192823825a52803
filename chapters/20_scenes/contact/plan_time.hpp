/// @file
/// The planner's rules on time and digits: from event to event or step by step, how long a step is,
/// float or double.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <contact/plan_bounds.hpp>
#include <contact/plan_contact.hpp>
#include <contact/plan_motion.hpp>
#include <contact/plan_types.hpp>
#include <contact/scene.hpp>

namespace contact {

/// That between impacts every spin stays as it is: a formula gives how a body lies.
inline Inequality nothing_turns_unevenly(const PlanQuestion& q) {
  return {"kinds of spin that a gyroscopic term may change",
          q.even_spins ? 0.0 : 1.0,
          Relation::equal,
          0,
          "none",
          ""};
}

/// What an event-driven run can hold: smooth hard balls, half-spaces and balls that stand still,
/// and what meets nothing and turns evenly.
inline std::vector<Inequality> event_conditions(const PlanQuestion& q) {
  double still = 0;
  double soft = 0;
  for (const PairBound& pair : q.pairs) {
    soft += pair.soft ? pair.count : 0;
    still += !pair.both_move && !pair.half_space && !is_ball(q.scene->bodies[pair.b]) ? 1 : 0;
  }
  return {{"moving bodies other than balls that may touch something", rough_shapes_that_touch(q),
           Relation::equal, 0, "none", ""},
          {"bodies that stand still and may be touched, other than half-spaces and balls", still,
           Relation::equal, 0, "none", ""},
          {"pairs that may meet and give way", soft, Relation::equal, 0, "none", ""},
          {"largest friction between bodies that may meet",
           proven_line(q) ? 0.0 : most_friction(q.pairs), Relation::equal, 0, "smooth", ""},
          nothing_turns_unevenly(q)};
}

/// The shortest flight that an event-driven run follows, if places may be off by a tolerance: a
/// hop of a ball under g that takes t rises by g t²/8.
/// @return s; half of the tolerance is used
inline double contact_time_cutoff(double tolerance, double gravity) {
  return std::sqrt(4 * tolerance / gravity);
}

// [event-rule]
/// From event to event only where the number of events is bounded.
///
/// Finitely many elastic balls hit each other finitely often (Burago, Ferleger and Kononenko 1998),
/// and with walls and gravity finitely often in a finite time (Galperin 1981), as long as nothing
/// rests. A ball on one half-space has a budget of bounces. A pair that flies freely meets once.
/// A ball that comes to rest on one half-space is followed until its hops are shorter than a
/// cutoff; their height is the error. No other error is accepted beside it: what else may be left
/// out within the tolerance touches nothing, or goes step by step. Everything else goes step by
/// step: that is the safe side.
inline Decision plan_event_driven(const PlanQuestion& q) {
  const std::vector<Inequality> common = event_conditions(q);
  const auto with = [&](std::string why, const std::vector<Inequality>& more) {
    Proof proof{std::move(why), common};
    proof.conditions.insert(proof.conditions.end(), more.begin(), more.end());
    return proof;
  };
  const bool lonely = most_partners(q) <= 1;
  double lossy = 0;
  double touching = 0;
  for (const PairBound& pair : q.pairs) {
    lossy = std::max(lossy, pair.hard ? 1 - pair.restitution_least : 0.0);
    touching += pair.apart || lonely ? 0 : 1;
  }
  const Inequality elastic{"largest share of speed lost, 1 − e, between bodies that may meet",
                           lossy,
                           Relation::equal,
                           0,
                           "elastic",
                           ""};
  // Bodies that touch hand a hit on at the same instant, and events come one after the other.
  const Inequality clear{"kinds of pairs that touch at the beginning beside others",
                         touching,
                         Relation::equal,
                         0,
                         "none",
                         ""};
  std::vector<Proof> proofs;
  for (const Proof& rest : resting_proofs(q)) {
    if (!is_proven(rest)) continue;
    std::vector<Inequality> more{elastic, clear};
    more.insert(more.end(), rest.conditions.begin(), rest.conditions.end());
    proofs.push_back(
        with("Elastic balls that never rest hit finitely often in a finite time.", more));
    break;
  }
  if (proofs.empty()) {
    std::vector<Inequality> more{elastic, clear};
    const std::vector<Proof> rest = resting_proofs(q);
    more.insert(more.end(), rest[2].conditions.begin(), rest[2].conditions.end());
    proofs.push_back(
        with("Elastic balls that never rest hit finitely often in a finite time.", more));
  }
  const BounceRange bounces = worst_bounces(q);
  proofs.push_back(with("Every ball has a budget of impacts.",
                        {{"most impacts of one ball", bounces.hits, Relation::less, 1e6,
                          "as many as a run may take for one ball", ""}}));
  // A hop that is left out: one half-space each, hard, pressed on by gravity.
  double other = 0;
  for (const PairBound& pair : q.pairs) other += pair.half_space && !pair.soft ? 0 : pair.count;
  const double cutoff = gravity_felt(q) > 0 ? contact_time_cutoff(q.left, q.bounds.gravity) : 0;
  const double hop = detail::rounded_up(q.bounds.gravity * cutoff * cutoff / 8);
  Proof hops = with(
      "A ball on one half-space is followed until its hops are shorter than " +
          number_text(static_cast<double>(static_cast<float>(cutoff))) + " s; after that it rests.",
      {{"most bodies that one moving body may touch", most_partners(q), Relation::at_most, 1,
        "one half-space", ""},
       {"pairs that may meet other than a ball and a hard half-space", other, Relation::equal, 0,
        "none", ""},
       {"a hop of no height", 0, Relation::less, hop, "height of a hop that is left out", "m"},
       fits_what_is_left(q, "height of a hop that is left out, g t²/8", hop)});
  hops.error = hop;
  hops.error_is = "height of the hops that are left out, g t²/8";
  proofs.push_back(std::move(hops));

  Decision decision = decide(Effect::event_driven, std::move(proofs),
                             "Not proven that the number of events is bounded: step by step.");
  // Here a proof switches on.
  decision.on = decision.planned = decision.proven;
  return decision;
}
// [/event-rule]

namespace detail {

/// How long a step is if nothing else decides: a frame.
inline double frame_step(const Scene& scene) {
  double h = std::min(1.0 / 60, scene.duration);
  if (scene.output.every > 0) h = std::min(h, scene.output.every);
  return h;
}

}  // namespace detail

// [step-rule]
/// The largest step with which the tolerance holds though contacts are looked for at steps only; a
/// frame where no step proves that, because then impacts are found between steps. So they are where
/// it would take more than a thousand steps a frame: to look for impacts costs less. A spring of
/// angular frequency ω takes at least 20 steps for each radian·π: h ≤ 1/(10 ω), far inside the
/// limit h ω < 2 of Euler's velocity-first step. While it may push, longest_spring_part() cuts the
/// step further.
/// @return s
inline double step_from_tolerance(const PlanQuestion& q) {
  double h = detail::frame_step(*q.scene);
  if (pairs_that_may_meet(q.bounds) == 0) return h;
  const double spring = detail::fastest_spring(q);
  if (spring > 0) h = std::min(h, 1 / (10 * spring));
  const BounceRange bounces = worst_bounces(q);
  if (!(q.left > 0) || !std::isfinite(bounces.late) || bounces.late == 0) return h;
  double shorter = std::min(h, detail::rounded_down(q.left / bounces.late, 256));
  for (int k = 0; k < 40; ++k, shorter /= 2) {
    bool all = true;
    if (shorter < h / 1024) break;
    for (const Inequality& condition : tunnelling_conditions(q, shorter))
      all = all && holds(condition);
    if (all) return shorter;
  }
  return h;
}

/// The step size as a decision: on with its value, or off from event to event.
inline Decision plan_step_size(const PlanQuestion& q, const PlanOptions& options) {
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
      options.step ? "The step is as asked for." : "The step follows from the tolerance.";
  // What a step would miss if nobody looked between two of them: what it does not hold, and first
  // of all what it costs.
  if (!q.pairs.empty()) {
    const std::vector<Inequality> missed = tunnelling_conditions(q, q.step);
    for (std::size_t k = 0; k < missed.size(); ++k)
      if (k == 1 || !holds(missed[k])) decision.because.push_back(missed[k]);
  }
  if (spring > 0)
    decision.because.push_back({"step times the stiffest spring's angular frequency",
                                q.step * spring, Relation::less, 2,
                                "limit of Euler's velocity-first step", ""});
  decision.proven = !decision.because.empty();
  for (const Inequality& condition : decision.because)
    decision.proven = decision.proven && holds(condition);
  if (q.pairs.empty()) {
    decision.proven = true;
    decision.why = q.even_spins
                       ? "Nothing touches anything and flights are exact, so any step does."
                       : "Nothing touches anything and flights are exact, so any step does; it is "
                         "cut into as many parts as a turn needs.";
  }
  if (!decision.proven && !options.step)
    decision.why = "Not proven that a step keeps the tolerance: it is a frame, and is looked into.";
  return decision;
}
// [/step-rule]

// [precision-rule]
/// Float is enough if nothing touches anything, spins stay, and a flight's rounding keeps within
/// what is left of the tolerance: in x + (v t + g t²/2) no term passes more than 8 roundings, each
/// off by at most u of the sum of the terms' sizes; and a turn by ω t is off by at most 32 u (1 +
/// |ω| t), which takes a point along by that times its distance. Without gravity a term is missing,
/// and the rest is rounded no worse. Squares of times and spins have to be numbers that a float
/// holds. After a hit rounding may grow, and nothing is proven.
inline Decision plan_double_precision(const PlanQuestion& q) {
  const Scene& scene = *q.scene;
  const double t = scene.duration;
  double size = 0;
  double turning = 0;
  // What float cannot square, and a tolerance below the squares that it loses.
  const auto beyond = [](double x) { return x > 0x1p60 ? 1.0 : 0.0; };
  double unfit = beyond(t) + beyond(q.bounds.gravity) + (q.left < 0x1p-80 ? 1 : 0);
  for (const SceneBody& body : scene.bodies) {
    if (!body.moves) continue;
    unfit += beyond(body.spin.norm());
    for (int k = 0; k < 3; ++k) {
      // The input is rounded too, so each factor is off by u before anything is computed.
      size = std::max(size, std::abs(body.position(k)) + std::abs(body.velocity(k)) * t +
                                std::abs(scene.gravity(k)) * t * t / 2);
    }
    if (!body.spin.isZero(0))
      turning = std::max(turning, spin_arm(body.shape) * (1 + body.spin.norm() * t));
  }
  const double rounding =
      detail::rounded_up(tolerance::unit_roundoff<float> * (16 * size + 32 * turning));
  return decide(
      Effect::double_precision,
      {{"A free flight in float is off by its roundings alone.",
        {nothing_meets(q),
         fits_what_is_left(q, "rounding of a flight in float", rounding),
         nothing_turns_unevenly(q),
         {"numbers whose squares a float does not hold", unfit, Relation::equal, 0, "none", ""}},
        rounding,
        "rounding in float"}},
      "Not proven that float keeps the tolerance: a hit may make rounding grow.");
}
// [/precision-rule]

}  // namespace contact
