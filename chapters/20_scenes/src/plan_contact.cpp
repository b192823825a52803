#include <contact/plan/plan_rules.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <contact/plan/plan_bounds.hpp>
#include <contact/plan/plan_hypotheses.hpp>
#include <contact/plan/plan_spreading.hpp>
#include <contact/plan/plan_types.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/scene/scene.hpp>
#include <contact/vector.hpp>

namespace contact {

// [friction-rule]
CONTACT_SCENES_INLINE Decision plan_friction(const PlanInput& q) {
  std::vector<Proof> proofs{
      {"A friction impulse is at most μ times the normal impulse; with μ = 0 it is 0.",
       {{"largest friction between bodies that may meet", max_friction(q.pairs), Relation::equal, 0,
         "smooth", ""}}}};
  if (const auto line = proven_line(q)) proofs.push_back(*line);
  return decide(Effect::friction, std::move(proofs),
                "Not proven that no body slides along another.");
}
// [/friction-rule]

CONTACT_SCENES_INLINE Decision plan_restitution(const PlanInput& q) {
  double most = 0;
  double hard = 0;
  for (const PairBound& pair : q.pairs) {
    if (!pair.hard) continue;
    hard += pair.count;
    most = std::max(most, pair.max_restitution);
  }
  return decide(Effect::restitution,
                {{hard == 0 ? "Without hard contacts nothing bounces."
                            : "With e = 0 the term −e v of the speed after an impact adds a zero.",
                  {{"largest restitution of hard contacts that may occur", most, Relation::equal, 0,
                    "no rebound", ""}}}},
                "Some impact may have a rebound.");
}

namespace detail {

CONTACT_SCENES_INLINE double fastest_spring(const PlanInput& q) {
  double most = 0;
  for (const PairBound& pair : q.pairs) {
    if (pair.soft) most = std::max(most, pair.stiffness * pair.inverse_mass);
  }
  return std::sqrt(most);
}

}  // namespace detail

// [spring-rule]
CONTACT_SCENES_INLINE double springs_off(const PlanInput& q, double substep) {
  constexpr double half_turn = 3.141592653589793;
  const double t = q.scene->duration;
  const double swing = detail::fastest_spring(q);
  double fastest = 0;
  for (const PairBound& pair : q.pairs) {
    if (!pair.soft) continue;
    if (pair.friction > 0 || pair.damping > 0) return detail::infinite;
    fastest = std::max(fastest, pair.closing);
  }
  const double contacts = 1 + swing * t / half_turn;
  const double share = swing * substep * (swing * substep);
  return detail::rounded_up(fastest * t * share * (1.0 / 24 + contacts / 8));
}

CONTACT_SCENES_INLINE double longest_spring_substep(const PlanInput& q) {
  const double swing = detail::fastest_spring(q);
  if (q.events || !(swing > 0)) return 0;
  const double longest = std::min(q.step, 1 / (128 * swing));
  const double off = springs_off(q, longest);
  if (!(q.tolerance_left > 0) || !(off > budget_share(q))) return longest;
  const double substep = detail::rounded_down(longest * std::sqrt(budget_share(q) / off), 256);
  return substep < q.step / 1024 ? longest : substep;
}

CONTACT_SCENES_INLINE Decision plan_penalty_contact(const PlanInput& q) {
  double soft = 0;
  for (const PairBound& pair : q.pairs) soft += pair.soft ? pair.count : 0;
  Decision decision =
      decide(Effect::penalty_contact,
             {{"A spring that nothing touches exerts no force.",
               {{"pairs that may meet and are compliant", soft, Relation::equal, 0, "none", ""}}}},
             "Some contacts are compliant, like springs.");
  const double substep = longest_spring_substep(q);
  if (!decision.on || !(substep > 0)) return decision;
  decision.because.push_back({"substep while a spring pushes", substep, Relation::at_most,
                              1 / (128 * detail::fastest_spring(q)),
                              "1/128 of a radian of the stiffest spring", "s"});
  const double off = springs_off(q, substep);
  decision.because.push_back(fits_tolerance(q, "error of leapfrog at the end, estimated", off));
  if (!holds(decision.because.back())) return decision;
  decision.error = off;
  decision.error_is = "error of leapfrog at springs, estimated; no bound for many bodies";
  return decision;
}
// [/spring-rule]

CONTACT_SCENES_INLINE double max_partners(const PlanInput& q) {
  std::vector<double> partners(q.scene->bodies.size(), 0.0);
  double most = 0;
  for (const PairBound& pair : q.pairs) {
    if (pair.crowd) return static_cast<double>(q.bounds.movers) - 1;
    most = std::max(most, partners[pair.a] += 1);
    if (pair.both_move) most = std::max(most, partners[pair.b] += 1);
  }
  return most;
}

// [several-contacts-rule]
CONTACT_SCENES_INLINE Decision plan_several_contacts(const PlanInput& q) {
  Decision decision = decide(Effect::several_contacts,
                             {{proof_claim("one-contact"),
                               {required(q, "one-contact/one-partner", max_partners(q), 1),
                                required(q, "one-contact/only-balls", touching_non_balls(q))}}},
                             "Not proven that no body has two contacts at a time.");
  const double together = hits_at_once(q);
  if (!decision.on || !(together > 0)) return decision;
  decision.why +=
      q.events ? " This plan takes hits at one instant one after the other, in an order that "
                 "the scene does not give; in steps one impulse acts at all contacts at "
                 "once. The velocities after such a hit may depend on that."
               : " This plan finds one impulse for all contacts at once; from event to event "
                 "hits at one instant are taken one after the other, in an order that the "
                 "scene does not give. The velocities after such a hit may depend on that.";
  decision.because.push_back(
      {"pairs that touch at the start, or are hit at the same instant, "
       "beside others",
       together, Relation::equal, 0, "none", ""});
  return decision;
}
// [/several-contacts-rule]

// [bounce-range]
CONTACT_SCENES_INLINE BounceRange bounce_range(const PlanInput& q, const PairBound& pair) {
  using detail::infinite;
  using detail::rounded_down;
  using detail::rounded_up;
  constexpr double max_counted = 1e6;
  const BounceRange unknown{0, infinite, infinite};
  const Scene& scene = *q.scene;
  const SceneBody& body = scene.bodies[pair.a];
  const auto* wall = std::get_if<HalfSpaceShape>(&scene.bodies[pair.b].shape);
  const auto* ball = std::get_if<BallShape>(&body.shape);
  if (wall == nullptr || ball == nullptr || pair.soft || !pair.apart) return unknown;
  const double doubt = 16 * detail::plan_u * q.bounds.gravity;
  const double g = -wall->normal.dot(scene.gravity) + doubt;
  const double e = pair.max_restitution;
  if (g <= 2 * doubt) {  // no force pulls it back
    if (q.bounds.gravity > 0 && g > 0 && detail::level_axis(wall->normal) < 0) return unknown;
    return {infinite, 1, rounded_up((1 + e) * (1 + pair.friction) * pair.closing)};
  }
  const double height = std::max(
      0.0, distance_at_least(scene.bodies[pair.b], body.position) - rounded_up(ball->radius));
  double away = wall->normal.dot(body.velocity);
  if (detail::level_axis(wall->normal) < 0) {
    const double off = 16 * detail::plan_u * detail::length_of(body.velocity);
    away = away > 0 ? std::max(0.0, away - off) : std::min(0.0, away + off);
  }
  const double w = rounded_down(std::sqrt(away * away + 2 * g * height), 256);
  const double most =
      speed_at_most(q.bounds.groups[q.bounds.bodies[pair.a].group],
                    q.bounds.bodies[pair.a].inverse_mass, q.bounds.gravity, scene.duration);
  const double first = away > 0 ? (away + w) / g : (w - away > 0 ? 2 * height / (w - away) : 0.0);
  BounceRange range;
  const double flight = rounded_down(2 * e * w / g, 256);
  range.rest = e < 1 ? rounded_down(first + flight / (1 - e), 512) : infinite;
  if (w == 0) return unknown;
  double time = rounded_down(first, 512);
  double length = flight;
  double share = 1;
  for (; time <= scene.duration; time += length, length *= e, share *= e) {
    if (++range.hits > max_counted || !(range.rest > scene.duration)) {
      range.hits = infinite;
      break;
    }
    range.late += (1 + e) * (most + pair.friction * g * scene.duration);
  }
  // A ball that leaves late leaves from too deep: gravity takes more of its speed than it should,
  // unless it takes all of it.
  if (pair.min_restitution < 1 || range.hits == infinite) range.late = infinite;
  range.late = rounded_up(range.late);
  return range;
}
// [/bounce-range]

CONTACT_SCENES_INLINE BounceRange worst_bounces(const PlanInput& q) {
  BounceRange worst;
  if (max_partners(q) > 1) return {0, detail::infinite, detail::infinite};
  for (const PairBound& pair : q.pairs) {
    BounceRange range;
    if (pair.half_space) {
      range = bounce_range(q, pair);
    } else if (pair.both_move && pair.round && !pair.soft) {
      // Both are accelerated equally: they meet once, on a straight relative path.
      range = {detail::infinite, 1, detail::rounded_up((1 + pair.max_restitution) * pair.closing)};
    } else {
      range = {0, detail::infinite, detail::infinite};
    }
    worst.rest = std::min(worst.rest, range.rest);
    worst.hits = std::max(worst.hits, range.hits);
    worst.late = std::max(worst.late, range.late);
  }
  return worst;
}

CONTACT_SCENES_INLINE double earliest_rest(const PlanInput& q) {
  double rest = detail::infinite;
  for (const PairBound& pair : q.pairs) {
    if (!pair.half_space || !pair.round || pair.soft) continue;
    PairBound free = pair;
    free.apart = true;  // other pairs are a hypothesis of their own
    rest = std::min(rest, bounce_range(q, free).rest);
  }
  return rest;
}

// [resting-rule]
CONTACT_SCENES_INLINE std::vector<Proof> resting_proofs(const PlanInput& q) {
  double hard = 0;
  double soft = 0;
  double lossy = 0;
  double uneven = 0;
  double touching = 0;
  double posts = 0;       // fixed balls
  double lying = 0;       // pairs of a half-space and a body that touches it
  double other = 0;       // pairs of which no bounce range is known
  double rough_post = 0;  // fixed balls with friction
  for (const PairBound& pair : q.pairs) {
    soft += pair.soft ? pair.count : 0;
    const bool flight = pair.both_move && pair.round && !pair.soft;
    const bool bounces = pair.half_space && pair.round && !pair.soft;
    other += flight || bounces ? 0 : pair.count;
    lying += bounces && !pair.apart ? 1 : 0;
    if (!pair.hard) continue;
    const bool post = !pair.both_move && !pair.half_space;
    hard += pair.count;
    lossy = std::max(lossy, 1 - pair.min_restitution);
    uneven += pair.round ? 0 : pair.count;
    touching += pair.apart ? 0 : 1;
    posts += post ? pair.count : 0;
    rough_post += post && pair.friction > 0 ? pair.count : 0;
  }
  const bool falls = gravity_felt(q) > 0;
  const double rough = rough_pairs_beside_others(q);
  return {
      {proof_claim("weightless"),
       {required(q, "weightless/no-gravity", gravity_felt(q)),
        required(q, "weightless/no-turning-shapes", proven_line(q) ? 0.0 : touching_non_balls(q)),
        required(q, "weightless/no-springs", soft)}},
      {proof_claim("only-springs"), {required(q, "only-springs/no-hard-pairs", hard)}},
      {proof_claim("elastic-balls"),
       {required(q, "elastic-balls/elastic", lossy),
        required(q, "elastic-balls/only-balls", uneven),
        required(q, "elastic-balls/apart", touching),
        required(q, "elastic-balls/smooth-beside-others", rough > 0 ? rough : rough_post),
        required(q, "elastic-balls/no-springs", hard > 0 ? soft : 0.0),
        required(q, "elastic-balls/no-fixed-balls", falls ? posts : 0.0)}},
      {proof_claim("last-bounce"),
       {required(q, "last-bounce/ends-before", q.scene->duration, earliest_rest(q)),
        required(q, "last-bounce/one-partner", max_partners(q), 1),
        required(q, "last-bounce/only-half-spaces", other),
        required(q, "last-bounce/apart", lying)}}};
}

CONTACT_SCENES_INLINE double max_skipped_bounce(const PlanInput& q) {
  if (all_fall_equally(q)) return 0;
  double size = 0;
  for (const SceneBody& body : q.scene->bodies)
    size = std::max(size, body.moves ? detail::coordinate_size(body.position) : 0.0);
  return q.tolerance_left > 0 ? budget_share(q) : detail::plan_u * size;
}

namespace detail {

/// The highest bounce that a pair leaves out in steps, m: e times the speed of the slowest bounce.
/// @param height from max_skipped_bounce(), m
CONTACT_SCENES_INLINE double pair_skipped_bounce(const PlanInput& q, const PairBound& pair,
                                                 double height) {
  if (!pair.hard) return 0;
  const double e = pair.max_restitution;
  const double in_a_step = pair_pressing(q, pair) * q.step * q.step / 8;
  return rounded_up(e * e * std::min(in_a_step, height));
}

}  // namespace detail

CONTACT_SCENES_INLINE Decision plan_resting(const PlanInput& q) {
  Decision decision =
      decide(Effect::resting, resting_proofs(q), "Not proven that nothing comes to rest.");
  if (!decision.on || q.events || !(q.tolerance_left > 0)) return decision;
  const double height = max_skipped_bounce(q);
  double bounce = 0;
  for (const PairBound& pair : q.pairs)
    bounce = std::max(bounce, detail::pair_skipped_bounce(q, pair, height));
  if (!(bounce > 0)) return decision;
  decision.because.push_back(fits_tolerance(q, "height of a bounce that steps leave out", bounce));
  if (rests_alone(q, [&](const PairBound& pair) {
        return detail::pair_skipped_bounce(q, pair, height) > 0;
      })) {
    decision.error = bounce;
    decision.error_is = "height of the bounces that steps leave out";
  } else {
    decision.error = detail::infinite;
    decision.error_is =
        "bounces that are left out may add up where bodies lie on or hit each other, or have "
        "friction";
  }
  return decision;
}
// [/resting-rule]

CONTACT_SCENES_INLINE Decision plan_sleeping(const PlanInput& q) {
  std::vector<Proof> proofs;
  for (Proof& proof : resting_proofs(q)) {
    if (!is_proven(proof)) continue;
    proof.why = "A body that never rests never sleeps. " + proof.why;
    proofs.push_back(std::move(proof));
    break;
  }
  if (proofs.empty()) proofs = resting_proofs(q);
  Decision decision =
      decide(Effect::sleeping, std::move(proofs),
             "Bodies may come to rest; a body in equilibrium at speed 0 stays exactly there.");
  const double share = sleeping_share(q);
  if (!decision.on || q.events || !(share > 0)) return decision;
  if (gravity_felt(q) > 0 && all_fall_equally(q)) return decision;
  decision.because.push_back(fits_tolerance(
      q, "distance that a sleeping body would creep at its speed or acceleration", share));
  if (rests_alone(q, [&](const PairBound& pair) {
        const bool glides = pair.half_space && pair.round && !pair.soft && pair.friction == 0;
        return !glides || detail::pair_pressing(q, pair) > 0;
      })) {
    decision.error = share;
    decision.error_is = "distance that sleeping bodies would creep";
  } else {
    decision.error = detail::infinite;
    decision.error_is = "a sleeping body may be balanced on an edge, and would fall later";
  }
  return decision;
}

namespace detail {

CONTACT_SCENES_INLINE std::string pair_name(const Scene& scene, const PairBound& pair) {
  if (pair.crowd && pair.both_move) return "any two moving bodies";
  if (pair.crowd) return "any moving body and " + scene.bodies[pair.b].name;
  const std::string& a = scene.bodies[pair.a].name;
  const std::string& b = scene.bodies[pair.b].name;
  return a < b || !pair.both_move ? a + " and " + b : b + " and " + a;
}

}  // namespace detail

/// What can be missed between two steps of length h, if contacts are tested at steps only.
///
/// *Tunnelling.* Each body consists of a core and all points within its thickness of it. While the
/// bodies do not touch, their cores are more than the sum R of both thicknesses apart. To come out
/// on the other side, the cores must meet in between, so the surfaces approach by more than R and
/// separate by more than R: more than 2 R in one step. The condition is the strict inequality, so
/// that rounded positions may miss an exact touch. Rotation and acceleration are included in the
/// speed that energy allows.
///
/// *Late hits.* A hit is detected up to a step late, and each displaces a body by at most (1 + e) v
/// h. On a floor that holds for e = 1 only: a slower ball would leave from too deep, slower still.
/// Friction along the floor gets a normal impulse that is wrong by what gravity adds meanwhile,
/// which leaves μ (1 + e) g h of velocity.
///
/// *Oblique hits.* Two balls that meet late have a normal that is rotated by at most asin(d/R),
/// with their displacement d in the step and the sum R of their radii. So the impulse is wrong by
/// (1 + e) v asin(d/R), for the rest of the time T. A chord that is missed altogether leaves less:
/// its length is at most d, and the normal speed is v d/(2 R). With friction nothing is proven. A
/// path that gravity bends away from a wall dips into it with at most g h/2; the lateness that is
/// charged is more, since a body that falls for T has a v of at least g T/2.
///
/// *No other errors are added.* Late hits have a bound only where bodies touch and none comes to
/// rest; where bounces, sleep, gravity, a gyroscopic term or float are left out within the
/// tolerance, nothing touches or bodies rest. A path of late hits is the exact one, delayed, except
/// for dips into a floor that are shorter than the error: EnergyShare::twice_dip is the energy
/// gained in them.
/// @param h s
CONTACT_SCENES_INLINE std::vector<Inequality> tunnelling_conditions(const PlanInput& q, double h) {
  using detail::rounded_up;
  const Scene& scene = *q.scene;
  std::vector<Inequality> conditions;
  double edged = 0;
  double grazing = 0;
  double worst = -1;
  Inequality passing;
  // [tunnelling]
  for (const PairBound& pair : q.pairs) {
    edged += pair.half_space ? (pair.round ? 0 : pair.count) : (pair.graze > 0 ? 0 : pair.count);
    if (pair.half_space) continue;
    const double moved = rounded_up(pair.closing * h);
    const double thrown = (1 + pair.max_restitution) * scene.duration * pair.closing;
    if (pair.graze > 0 && pair.friction == 0) {
      const double turned = std::asin(std::min(1.0, rounded_up(moved / pair.graze)));
      grazing = std::max(grazing, rounded_up(thrown * turned));
    } else if (pair.friction > 0) {
      grazing = detail::infinite;
    }
    const double ratio = pair.core > 0 ? moved / (2 * pair.core) : detail::infinite;
    const std::string name = detail::pair_name(scene, pair);
    const std::string words = "approach of " + name + " in a step";
    if (ratio < worst || (ratio == worst && passing.left_is < words)) continue;
    worst = ratio;
    passing = {words, moved, Relation::less, 2 * pair.core, "twice the thickness of both together",
               "m"};
  }
  // [/tunnelling]
  if (worst >= 0) {
    conditions.push_back(passing);
  } else {
    conditions.push_back({"pairs that may meet and of which none is a half-space", 0,
                          Relation::equal, 0, "a half-space has no other side", ""});
  }
  const double late = q.pairs.empty() ? 0.0 : rounded_up(worst_bounces(q).late * h);
  conditions.push_back(
      fits_tolerance(q, "error at the end by hits that are late, or oblique and missed",
                     rounded_up(late + grazing)));
  conditions.push_back(
      {"pairs with vertices or edges that may meet, whose missed grazes have no bound", edged,
       Relation::equal, 0, "none", ""});
  return conditions;
}

/// Continuous detection is off if nothing can pass through anything between two steps, and late and
/// missed hits stay within the tolerance. In an event-driven run it is on: an event is an impact at
/// its time.
CONTACT_SCENES_INLINE Decision plan_continuous_detection(const PlanInput& q, double h) {
  const double pairs = pairs_that_may_meet(q.bounds);
  Proof free{"Nothing touches anything, whatever the step.", {nothing_meets(q)}};
  if (q.events && pairs > 0) {
    Decision decision = decide(Effect::continuous_detection, {free},
                               "From event to event each impact is found at its time; there is no "
                               "step in which it could be missed.");
    decision.because.clear();
    return decision;
  }
  Proof steps{
      "To pass through each other, two bodies must approach by twice the thickness of "
      "their cores in one step.",
      tunnelling_conditions(q, h)};
  for (const Inequality& condition : steps.conditions) {
    if (condition.relation == Relation::at_most)
      steps.error = std::max(steps.error, condition.left);
  }
  steps.error_is = "hits up to a step late, and grazing hits that are missed";
  const std::vector<Inequality> all = steps.conditions;
  Decision decision = decide(Effect::continuous_detection, {free, steps},
                             "Not proven that what is missed between two steps is small.");
  if (decision.on) decision.because = all;
  return decision;
}

}  // namespace contact
