/// @file
/// The planner's rules on how bodies move: gravity, rotation, the gyroscopic term, and motion that
/// stays in a plane or on a line. One rule a function; each says by what theorem it is sound.
/// The planner's rules on contacts: friction, restitution, what gives way, several at once, rest,
/// sleep, and what passes between two steps.
/// The planner's rule on the broad phase: whether pairs are worth sorting out beforehand.
/// The planner's rules on time and digits: from event to event or step by step, how long a step is,
/// float or double.
/// Until when places can be predicted: an estimate, not a proof.
/// How many of each thing a run is expected to have: impacts, parts of steps, contacts that last.
/// Estimates, not proofs.
/// What each effect costs, estimated before the run: how many of each thing to expect, times what
/// one costs.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <contact/aabb.hpp>
#include <contact/broad_phase_cost.hpp>
#include <contact/closest_points.hpp>
#include <contact/convex_hull.hpp>
#include <contact/gap.hpp>
#include <contact/inertia.hpp>
#include <contact/plan/plan_bounds.hpp>
#include <contact/plan/plan_costs.hpp>
#include <contact/plan/plan_types.hpp>
#include <contact/scene/scene.hpp>
#include <contact/vector.hpp>

namespace contact {

/// What every rule of the planner looks at. Make it with plan_question().
struct PlanQuestion {
  const Scene* scene = nullptr;  ///< what is planned
  SceneBounds bounds;            ///< what its energy allows
  int table = -1;                ///< the axis of a level table that cancels gravity; −1: none
  std::vector<PairBound> pairs;  ///< that may meet, without balls and the table that they lie on
  double tolerance = 0;          ///< of a place, m; 0: none is given
  double left = 0;               ///< of the tolerance, for errors that are not accepted yet, m
  bool even_spins = false;       ///< no gyroscopic term changes a spin
  bool events = false;           ///< whether the run goes from event to event
  double step = 0;               ///< s; 0 with events
};

/// What an error is compared with.
/// @param error of the effect that is asked about, m
Inequality fits_what_is_left(const PlanQuestion& q, std::string error_is, double error);

/// Takes what a decision accepts from what is left, rounded down.
void take_from_what_is_left(PlanQuestion& q, const Decision& decision);

/// How much a rule takes that may choose its error.
double chosen_share(const PlanQuestion& q);

/// "x", "y" or "z".
inline std::string axis_name(int axis) { return axis == 0 ? "x" : (axis == 1 ? "y" : "z"); }

/// The largest friction between bodies that may meet.
inline double most_friction(const std::vector<PairBound>& pairs) {
  double most = 0;
  for (const PairBound& pair : pairs) most = std::max(most, pair.friction);
  return most;
}

/// How many moving bodies are no balls and may touch something.
inline double rough_shapes_that_touch(const PlanQuestion& q) {
  double count = 0;
  for (std::size_t i = 0; i < q.bounds.bodies.size(); ++i)
    count += q.bounds.bodies[i].disturbed && !is_ball(q.scene->bodies[i]) ? 1 : 0;
  return count;
}

/// That no pair of bodies may meet.
Inequality nothing_meets(const PlanQuestion& q);

/// Smooth balls: a contact's force on a ball runs through its centre if nothing rubs. So spin never
/// changes, and it changes nothing; a ball looks alike however it lies. Bodies of another shape
/// must touch nothing and not spin.
Proof smooth_balls(const PlanQuestion& q);

/// A scene that is its own mirror image across an axis.
/// @param axis 0, 1 or 2: x, y or z
std::vector<Inequality> mirror_conditions(const PlanQuestion& q, int axis);

/// The plane-motion proof for an axis.
inline Proof plane_motion(const PlanQuestion& q, int axis) {
  return {
      "The scene is its own mirror image across " + axis_name(axis) +
          "; the laws of motion are symmetric under reflection, so nothing ever moves along it.",
      mirror_conditions(q, axis)};
}

/// The line-motion proof: two mirrors at once leave one axis, and no spin at all.
Proof line_motion(const PlanQuestion& q, int along);

/// The line-motion proof that holds, if one does.
std::optional<Proof> proven_line(const PlanQuestion& q);

/// Balls on a level table without friction: what presses them down is what the table pushes back,
/// and no contact between balls of one height has a component up or down. Then neither gravity nor
/// the table changes the motion. Heights are compared exactly.
/// @param axis of gravity
std::vector<Inequality> table_conditions(const PlanQuestion& q, int axis);

/// What the rules look at: the bounds, and whether a table cancels gravity.
PlanQuestion plan_question(const Scene& scene);

/// Gravity that a body feels: what no table cancels, m/s².
inline double gravity_felt(const PlanQuestion& q) { return q.table >= 0 ? 0.0 : q.bounds.gravity; }

/// Gravity is off if there is none, if nothing moves, if a table cancels it, or if nothing touches
/// anything and free fall through the whole duration is shorter than what is left of the tolerance.
Decision plan_gravity(const PlanQuestion& q);

/// Rotation is off for smooth balls, and where two mirrors leave no room for spin.
inline Decision plan_rotation(const PlanQuestion& q) {
  std::vector<Proof> proofs{smooth_balls(q)};
  if (const auto line = proven_line(q)) proofs.push_back(*line);
  return decide(Effect::rotation, std::move(proofs), "Not proven that rotation changes nothing.");
}

/// The gyroscopic term ω × I ω is 0 for a body whose moments are all equal, and for a spin along a
/// principal axis that a mirror keeps there. A body that touches nothing turns away from where it
/// would be without the term by at most ½ α T², with α = (I₃ − I₁)/I₁ · |ω|² the largest change of
/// its spin that the term can make. Neither place nor gravity is in that, so it holds without
/// gravity as well.
Decision plan_gyroscopic_term(const PlanQuestion& q);

/// The third dimension is off if the scene is its own mirror image across an axis.
inline Decision plan_third_dimension(const PlanQuestion& q) {
  std::vector<Proof> proofs;
  for (int axis = 2; axis >= 0; --axis) proofs.push_back(plane_motion(q, axis));
  return decide(Effect::third_dimension, std::move(proofs),
                "Not proven that motion stays in a plane perpendicular to x, y or z.");
}

/// The second dimension is off if the scene is its own mirror image across two axes.
inline Decision plan_second_dimension(const PlanQuestion& q) {
  std::vector<Proof> proofs;
  for (int along = 2; along >= 0; --along) proofs.push_back(line_motion(q, along));
  return decide(Effect::second_dimension, std::move(proofs),
                "Not proven that motion stays on a line along x, y or z.");
}

/// Friction is off if no two bodies that may meet rub, or if all motion is along one line, where
/// surfaces that touch never slide along each other.
Decision plan_friction(const PlanQuestion& q);

/// Restitution is off if every hard contact that may happen returns nothing (e = 0): the impulse
/// only stops the approach.
Decision plan_restitution(const PlanQuestion& q);

namespace detail {

/// The stiffest spring's ω = √(k (1/m + 1/m')), rad/s.
double fastest_spring(const PlanQuestion& q);

}  // namespace detail

/// How far off springs may be at the end that push in parts of a length p: an estimate, from what
/// leapfrog leaves of the motion of one pair along its normal.
///
/// It swings too fast, by (ω p)²/24 of the time. And a spring lets go within a part. Its push is
/// taken in the part's middle, so at the speed v, with τ of the part to go, ω² v (τ²/2 − (τ − p/2)
/// p) of velocity is missing or too much: v (ω p)²/8 at most. (Where it begins to push is found,
/// and ends a part.) A contact lasts half a swing or longer, so in the time T there are at most 1 +
/// ω T/π, and what each of them leaves counts for the rest of the time. Dampers that see a part's
/// end, and friction, are of first order in p: of them nothing is said. Nor is it a bound where
/// bodies hit one another in turn.
/// @param part p, s
/// @return m; ∞ if nothing is said
double springs_off(const PlanQuestion& q, double part);

/// How long a part of a step is at most while a spring may push: so that springs_off() is half of
/// what is left of the tolerance, and no more than 1/128 of a radian of the stiffest spring, which
/// keeps the energy of a swing to 2e-5. That is all where the tolerance would take more than a
/// thousand parts a step.
/// @return s; 0 if no spring may push
double longest_spring_part(const PlanQuestion& q);

/// Penalty contact is off if nothing that may be touched gives way. On, it takes what springs_off()
/// says, if that is within what is left of the tolerance.
Decision plan_penalty_contact(const PlanQuestion& q);

/// The most bodies that one moving body may touch, without a table that cancels gravity.
double most_partners(const PlanQuestion& q);

/// Several contacts at a time need two partners, or a shape that can touch at more than one point.
Decision plan_several_contacts(const PlanQuestion& q);

/// How a ball over one half-space bounces, at the least and at the most.
struct BounceRange {
  double rest = detail::infinite;  ///< it does not come to rest before this, s, rounded down
  double hits = 0;                 ///< no more impacts in the whole duration, rounded up
  double late = 0;  ///< of all impacts together, m/s: times the step, what lateness costs
};

/// The bounces of a ball whose only partner is a half-space, by its normal motion alone: friction
/// and spin do not change that. Flight k takes 2 eᵏ w/g, so all end at t₁ + 2 e w/(g (1 − e)).
/// @return nothing proven (rest 0, hits and late ∞) for a ball that begins on the half-space, for
/// contacts that give way, or beyond a million impacts
BounceRange bounce_range(const PlanQuestion& q, const PairBound& pair);

/// The worst of all bounces, if each moving body has one half-space as its only partner; nothing
/// proven otherwise.
BounceRange worst_bounces(const PlanQuestion& q);

/// The ways to show that no contact lasts and carries a force.
///
/// Nothing presses without gravity, but for a body that turns and pushes another along: a ball on a
/// rod that swings round. Elastic balls leave at the speed at which they came, which is
/// never 0: a flight that only grazes what gravity presses it on would have come from inside. (Hits
/// that fall on one instant are the business of the rule on several contacts.) And a ball that
/// bounces on one half-space does not rest before its last bounce.
std::vector<Proof> resting_proofs(const PlanQuestion& q);

/// Whether gravity presses nothing together: there is none, or nothing that may be met stands
/// still. Then all fall alike, and what flies off does not come back.
inline bool all_fall_alike(const PlanQuestion& q) {
  bool stands = false;
  for (const PairBound& pair : q.pairs) stands = stands || !pair.both_move;
  return !stands || !(gravity_felt(q) > 0);
}

/// How high a hop is, at most, that steps leave out where things come to rest: half of what is left
/// of the tolerance; where nothing is left, as much as places are rounded. Along each contact's
/// normal it is also shorter than a step: slowest_bounce() makes a speed of both.
/// @return m; 0: none is left out
double hops_left_out(const PlanQuestion& q);

namespace detail {

/// How hard gravity may press a pair together, m/s²: on a half-space to rounding, 0 if it pulls
/// away.
inline double pair_pressing(const PlanQuestion& q, const PairBound& pair) {
  if (!pair.half_space) return q.bounds.gravity;
  const auto& wall = std::get<HalfSpaceShape>(q.scene->bodies[pair.b].shape);
  const double along = -wall.normal.dot(q.scene->gravity);
  return along > 16 * plan_u * q.bounds.gravity ? along : 0;
}

}  // namespace detail

/// Whether what lies on something lies there alone: a smooth ball on one hard half-space, beside
/// which it may meet only walls at right angles to that one, smooth and hard too. Then the motion
/// along the half-space knows nothing of the motion along its normal: whoever lies down too early,
/// or sleeps, is off by what that leaves out, and no more.
/// @param lasts of a pair: whether leaving something out there counts
template <class Lasts>
bool rests_alone(const PlanQuestion& q, const Lasts& lasts) {
  const auto normal = [&](const PairBound& pair) {
    return std::get<HalfSpaceShape>(q.scene->bodies[pair.b].shape).normal;
  };
  for (const PairBound& under : q.pairs) {
    if (!lasts(under)) continue;
    if (q.bounds.crowded || !under.half_space || !under.round) return false;
    for (const PairBound& other : q.pairs) {
      if (other.a != under.a && !(other.both_move && other.b == under.a)) continue;
      if (!other.half_space || other.soft || other.friction > 0) return false;
      if (other.b == under.b) continue;
      if (normal(other).dot(normal(under)) != 0 || detail::pair_pressing(q, other) > 0)
        return false;
    }
  }
  return true;
}

/// Resting contact is off if one of resting_proofs() holds. On, steps leave out hops no higher than
/// hops_left_out(): a ball that lies down in place of a hop on its floor is off by the hop's
/// height, and all hops after it are lower. That is a bound if rests_alone(). Where bodies lie on
/// or hit each other, or rub, a hop that is left out may change what comes after, and the plan says
/// that there is no bound.
Decision plan_resting(const PlanQuestion& q);

/// How far a body that sleeps may be off: half of the tolerance, or what is left of it.
inline double sleeping_share(const PlanQuestion& q) { return std::min(q.left, q.tolerance / 2); }

/// Sleeping is off where nothing rests. Leaving it off is never wrong; it only costs time. On, it
/// takes sleeping_share(): a body sleeps that would not come farther in the whole duration T, if it
/// went on at the speed s, or if what has pushed it so far in sleep_after() went on to: s T and s
/// T²/τ. That is a bound if rests_alone(): gravity pushes evenly then. It is none for what
/// balances: a body on its edge falls ever faster. And what only falls is never slow for so long.
Decision plan_sleeping(const PlanQuestion& q);

/// How slow a body must be to sleep, m/s.
/// @param sleeping the decision on it
inline double sleep_speed(const PlanQuestion& q, const Decision& sleeping) {
  const double t = q.scene->duration;
  return sleeping.error > 0 ? sleeping_share(q) / std::max(t, t * t / sleep_after) : 0;
}

/// What can go unseen between two steps of length h, if contacts are looked for at steps only.
/// @param h s
std::vector<Inequality> tunnelling_conditions(const PlanQuestion& q, double h);

/// Continuous detection is off if nothing can pass through anything between two steps, and what
/// comes late or is missed stays within the tolerance.
Decision plan_continuous_detection(const PlanQuestion& q, double h);

namespace detail {

/// The space that moving bodies have: between level walls where there are any, else round them.
struct Room {
  Vector3<double> size = Vector3<double>::Zero();  ///< m
  double widest = 0;                               ///< largest diameter of a moving body, m
  double mean = 0;                                 ///< mean diameter, m
  std::array<bool, 3> walled{};                    ///< on both sides, by axis
};

Room room_of(const Scene& scene);

}  // namespace detail

/// What finding the pairs that are near costs in one part, by cells and by comparing all, without
/// the boxes that both need.
struct PairSearchCost {
  double all = 0;    ///< instructions
  double cells = 0;  ///< instructions
};

/// The same counts as chapter 10's: pairs, entries in cells, pairs near enough to be compared. An
/// entry is sorted in half as many steps as its number has binary digits, and once more looked at.
/// @param boxes in an order of their own
PairSearchCost pair_search_cost(std::span<const Aabb<double>> boxes);

namespace detail {

/// Boxes about the ways of all that is bounded in a first step: of the balls about them. In an
/// order of their own, so that a scene's order changes nothing. None if one is out of all bounds.
std::vector<Aabb<double>> first_boxes(const Scene& scene, double h);

}  // namespace detail

/// A broad phase never changes what happens, so this is a question of cost alone.
Decision plan_broad_phase(const PlanQuestion& q);

/// That between impacts every spin stays as it is: a formula gives how a body lies.
Inequality nothing_turns_unevenly(const PlanQuestion& q);

/// What an event-driven run can hold: smooth hard balls, half-spaces and balls that stand still,
/// and what meets nothing and turns evenly.
std::vector<Inequality> event_conditions(const PlanQuestion& q);

/// The shortest flight that an event-driven run follows, if places may be off by a tolerance: a
/// hop of a ball under g that takes t rises by g t²/8.
/// @return s; half of the tolerance is used
inline double contact_time_cutoff(double tolerance, double gravity) {
  return std::sqrt(4 * tolerance / gravity);
}

/// From event to event only where the number of events is bounded.
///
/// Finitely many elastic balls hit each other finitely often (Vaserstein 1979; Burago, Ferleger and
/// Kononenko 1998 with a bound by number and masses alone), and with walls and gravity finitely
/// often in a finite time (Galperin 1981), as long as nothing rests. A ball on one half-space has a
/// budget of bounces. A pair that flies freely meets once. A ball that comes to rest on one
/// half-space is followed until its hops are shorter than a cutoff; their height is the error. No
/// other error is accepted beside it: what else may be left out within the tolerance touches
/// nothing, or goes step by step. Everything else goes step by step: that is the safe side.
Decision plan_event_driven(const PlanQuestion& q);

namespace detail {

/// How long a step is if nothing else decides: a frame.
inline double frame_step(const Scene& scene) {
  double h = std::min(1.0 / 60, scene.duration);
  if (scene.output.every > 0) h = std::min(h, scene.output.every);
  return h;
}

}  // namespace detail

/// The largest step with which the tolerance holds though contacts are looked for at steps only; a
/// frame where no step proves that, because then impacts are found between steps. So they are where
/// it would take more than a thousand steps a frame: to look for impacts costs less. A spring of
/// angular frequency ω takes at least 20 steps for each radian·π: h ≤ 1/(10 ω), far inside the
/// limit h ω < 2 of Euler's velocity-first step. While it may push, longest_spring_part() cuts the
/// step further.
/// @return s
double step_from_tolerance(const PlanQuestion& q);

/// The step size as a decision: on with its value, or off from event to event.
Decision plan_step_size(const PlanQuestion& q, const PlanOptions& options);

/// Float is enough if nothing touches anything, spins stay, and a flight's rounding keeps within
/// what is left of the tolerance: in x + (v t + g t²/2) no term passes more than 8 roundings, each
/// off by at most u of the sum of the terms' sizes; and a turn by ω t is off by at most 32 u (1 +
/// |ω| t), which takes a point along by that times its distance. Without gravity a term is missing,
/// and the rest is rounded no worse. Squares of times and spins have to be numbers that a float
/// holds. After a hit rounding may grow, and nothing is proven.
Decision plan_double_precision(const PlanQuestion& q);

namespace detail {

/// Before this nothing touches anything; 0 for a crowd, whose pairs are not asked one by one.
double first_touch(const PlanQuestion& q);

}  // namespace detail

/// Until when places can be predicted.
/// @param turning whether the plan has rotation
Decision plan_horizon(const PlanQuestion& q, bool turning);

// [expected-run]
/// How many of each thing a run is expected to have. Sums over pairs are taken in their order of
/// size, so that the order of a scene's bodies changes nothing.
struct ExpectedRun {
  double movers = 0;     ///< bodies that move
  double bounded = 0;    ///< bodies that are no half-spaces
  double walls = 0;      ///< half-spaces
  double hits = 0;       ///< impacts
  double wall_hits = 0;  ///< and of these, on half-spaces
  double crossings = 0;  ///< from cell to cell, from event to event
  double occupancy = 0;  ///< balls in a cell there
  double steps = 0;      ///< of time
  double parts = 0;      ///< into which impacts and springs cut them
  double awake = 1;      ///< share of the time in which not all sleep
  // Of pairs that go on touching, as many as there are on the average at any time:
  double touching = 0;      ///< pairs
  double contacts = 0;      ///< their points
  double unpressed = 0;     ///< and of the pairs, those that nothing presses
  double gaps = 0;          ///< what finding these points costs, instructions
  double impact = 0;        ///< what it costs to find when a pair comes to touch, instructions
  double spring_parts = 0;  ///< parts in which a spring pushes
  double looks = 0;         ///< parts of turns with the gyroscopic term
  PairSearchCost search;    ///< of each part
  bool cells = false;       ///< balls ask their neighbours only, from event to event
  bool heap = false;        ///< contacts are guessed: a crowd lies in a heap, three a body
};
// [/expected-run]

/// What to expect of a run of the scene.
/// @param h of a step, s
/// @param spring_part how long a part is while a spring pushes, s; 0: none does
/// @param sleeps whether what rests may sleep
ExpectedRun expected_run(const PlanQuestion& q, double h, double spring_part, bool sleeps);

/// Says of each effect what it costs in this run, beside a run without it. What a choice of
/// somebody's changes is not in it, but for events or steps.
/// @param h of a step, or of the step that would be taken, s
void estimate_savings(const PlanQuestion& q, double h, Plan& plan);

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/plan_contact.cpp"
#include "../../src/plan_expected.cpp"
#include "../../src/plan_horizon.cpp"
#include "../../src/plan_motion.cpp"
#include "../../src/plan_pairs.cpp"
#include "../../src/plan_savings.cpp"
#include "../../src/plan_time.cpp"
#endif
