/// @file
/// The planner's rules, one function each; each says by which theorem it is sound.
/// - Motion: gravity, rotation, the gyroscopic term, motion in a plane or on a line.
/// - Contacts: friction, restitution, compliant contacts, several at once, rest, sleep, tunnelling.
/// - Broad phase: whether sorting out pairs beforehand pays.
/// - Time and precision: event-driven or in steps, the step size, float or double.
/// - The horizon until which positions can be predicted: an estimate, not a proof.
/// - The expected numbers of impacts, substeps and lasting contacts, and from them the cost of each
/// effect: estimates, not proofs.
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
#include <contact/inertia.hpp>
#include <contact/plan/plan_bounds.hpp>
#include <contact/plan/plan_costs.hpp>
#include <contact/plan/plan_hypotheses.hpp>
#include <contact/plan/plan_types.hpp>
#include <contact/scene/scene.hpp>
#include <contact/signed_distance.hpp>
#include <contact/vector.hpp>

namespace contact {

/// The bodies that move, as they are at the start.
struct MotionRange {
  Vector3<double> velocity = Vector3<double>::Zero();  ///< largest size along each axis, m/s
  /// Largest component about another axis than each, rad/s
  Vector3<double> angular_velocity = Vector3<double>::Zero();
  /// How many are not their own mirror image across each axis
  Vector3<double> asymmetric = Vector3<double>::Zero();
  Vector3<double> low = Vector3<double>::Constant(detail::infinite);    ///< least coordinates, m
  Vector3<double> high = Vector3<double>::Constant(-detail::infinite);  ///< largest coordinates, m
  double rotating = 0;  ///< how many rotate and are not balls
  double touching = 0;  ///< how many may touch something and are not balls
};

/// The input of every rule of the planner. Make it with plan_input().
struct PlanInput {
  const Scene* scene = nullptr;    ///< the scene that is planned
  SceneBounds bounds;              ///< what its energy allows
  MotionRange motion;              ///< how its bodies move at the start
  int table = -1;                  ///< the axis of a level table that cancels gravity; −1: none
  std::vector<PairBound> pairs;    ///< that may meet, without balls and the table on which they lie
  double tolerance = 0;            ///< of a position, m; 0: none is given
  double tolerance_left = 0;       ///< rest of the error budget, m
  bool constant_rotation = false;  ///< no gyroscopic term changes an angular velocity
  bool events = false;             ///< whether the run goes from event to event
  double step = 0;                 ///< s; 0 with events
  std::vector<std::string> dropped;  ///< hypotheses that proofs leave out, PlanOptions::dropped
};

/// A condition from the table of hypotheses, for this plan.
inline Inequality required(const PlanInput& q, std::string_view id, double left, double right = 0) {
  return required(id, left, right, q.dropped);
}

/// Compares an error with the rest of the error budget.
/// @param error of the effect in question, m
Inequality fits_tolerance(const PlanInput& q, std::string error_is, double error);

/// Subtracts the error that a decision accepts from the error budget, rounded down.
void spend_tolerance(PlanInput& q, const Decision& decision);

/// The error that a rule takes if it may choose: half of the rest of the budget.
double budget_share(const PlanInput& q);

/// "x", "y" or "z".
inline std::string axis_name(int axis) { return axis == 0 ? "x" : (axis == 1 ? "y" : "z"); }

/// The largest friction between bodies that may meet.
inline double max_friction(const std::vector<PairBound>& pairs) {
  double most = 0;
  for (const PairBound& pair : pairs) most = std::max(most, pair.friction);
  return most;
}

/// How many moving bodies that are not balls may touch something.
inline double touching_non_balls(const PlanInput& q) { return q.motion.touching; }

/// The condition that no pair of bodies may meet.
Inequality nothing_meets(const PlanInput& q);

/// Smooth balls: without friction, the contact force on a ball acts through its centre, without
/// torque. So its angular velocity never changes, and changes nothing; a ball looks the same in
/// every orientation. Bodies of another shape must touch nothing and not rotate.
Proof smooth_balls(const PlanInput& q);

/// The conditions for a scene to be its own mirror image in a plane perpendicular to an axis.
/// @param axis 0, 1 or 2: x, y or z
std::vector<Inequality> mirror_conditions(const PlanInput& q, int axis);

/// The plane-motion proof for an axis.
inline Proof plane_motion(const PlanInput& q, int axis) {
  return {
      "The scene is its own mirror image across " + axis_name(axis) +
          "; the laws of motion are symmetric under reflection, so nothing ever moves along it.",
      mirror_conditions(q, axis)};
}

/// The line-motion proof: two mirrors leave one axis, and no rotation.
Proof line_motion(const PlanInput& q, int along);

/// The line-motion proof that holds, if one does.
std::optional<Proof> proven_line(const PlanInput& q);

/// Balls on a level table without friction: the table balances their weight, and contacts between
/// balls at the same height have no vertical component. Then neither gravity nor the table changes
/// the motion. Heights are compared exactly.
/// @param axis of gravity
std::vector<Inequality> table_conditions(const PlanInput& q, int axis);

/// The input of the rules: the bounds, and whether a table cancels gravity.
/// @param dropped hypotheses that proofs leave out: PlanOptions::dropped
PlanInput plan_input(const Scene& scene, std::vector<std::string> dropped = {});

/// Gravity that no table cancels, m/s².
inline double gravity_felt(const PlanInput& q) { return q.table >= 0 ? 0.0 : q.bounds.gravity; }

/// Gravity is off if it is zero, if nothing moves, if a table cancels it, or if nothing touches
/// anything and free fall over the whole duration is within the rest of the error budget.
Decision plan_gravity(const PlanInput& q);

/// Rotation is off for smooth balls, and where two mirrors exclude it.
inline Decision plan_rotation(const PlanInput& q) {
  std::vector<Proof> proofs{smooth_balls(q)};
  if (const auto line = proven_line(q)) proofs.push_back(*line);
  return decide(Effect::rotation, std::move(proofs), "Not proven that rotation changes nothing.");
}

/// The gyroscopic term ω × I ω is 0 for a body whose moments of inertia are all equal, and for an
/// angular velocity that mirror symmetry keeps along a principal axis. Without the term, the
/// orientation of a body that touches nothing is wrong by at most ½ α T², where α = (I₃ − I₁)/I₁ ·
/// (I₃/I₁) |ω|² bounds the angular acceleration by the term; |ω|² may grow by I₃/I₁ at constant
/// energy. Neither position nor gravity enters, so the bound also holds without gravity.
Decision plan_gyroscopic_term(const PlanInput& q);

/// The third dimension is off if the scene is its own mirror image in a plane perpendicular to an
/// axis.
inline Decision plan_third_dimension(const PlanInput& q) {
  std::vector<Proof> proofs;
  for (int axis = 2; axis >= 0; --axis) proofs.push_back(plane_motion(q, axis));
  return decide(Effect::third_dimension, std::move(proofs),
                "Not proven that motion stays in a plane perpendicular to x, y or z.");
}

/// The second dimension is off if the scene is its own mirror image in planes perpendicular to two
/// axes.
inline Decision plan_second_dimension(const PlanInput& q) {
  std::vector<Proof> proofs;
  for (int along = 2; along >= 0; --along) proofs.push_back(line_motion(q, along));
  return decide(Effect::second_dimension, std::move(proofs),
                "Not proven that motion stays on a line along x, y or z.");
}

/// Friction is off if no two bodies that may meet have friction, or if all motion is along one
/// line, where surfaces in contact never slide along each other.
Decision plan_friction(const PlanInput& q);

/// Restitution is off if every hard contact that may occur has e = 0: the impulse only stops the
/// approach.
Decision plan_restitution(const PlanInput& q);

namespace detail {

/// The stiffest spring's ω = √(k (1/m + 1/m')), rad/s.
double fastest_spring(const PlanInput& q);

}  // namespace detail

/// Error at the end of springs that push in substeps of length p: an estimate, from the error of
/// leapfrog (velocity Verlet) in the motion of one pair along its normal.
///
/// It oscillates too fast, by (ω p)²/24 of the time. And a spring may separate within a substep.
/// Its force is evaluated in the middle of the substep, so at the speed v, with τ of the substep
/// left, the velocity is wrong by ω² v (τ²/2 − (τ − p/2) p): at most v (ω p)²/8. (The start of the
/// contact is found, and ends a substep.) A contact lasts at least half an oscillation, so in the
/// time T there are at most 1 + ω T/π, and the error of each counts for the rest of the time.
/// Dampers that are evaluated at the end of a substep, and friction, are of first order in p: for
/// them there is no estimate. Nor is this a bound where bodies hit one another in turn.
/// @param substep p, s
/// @return m; ∞ if there is no estimate
double springs_off(const PlanInput& q, double substep);

/// The longest substep while a spring may push: such that springs_off() is half of the rest of the
/// error budget, and at most 1/128 of a radian of the stiffest spring, which conserves the energy
/// of an oscillation to 2e-5. Only the latter holds where the tolerance would take more than a
/// thousand substeps a step.
/// @return s; 0 if no spring may push
double longest_spring_substep(const PlanInput& q);

/// Penalty contact is off if no contact that may occur is compliant. On, it takes springs_off()
/// from the error budget, if the budget is large enough.
Decision plan_penalty_contact(const PlanInput& q);

/// The largest number of bodies that one moving body may touch, not counting a table that cancels
/// gravity.
double max_partners(const PlanInput& q);

/// Several contacts at once need two partners, or a shape that can touch at more than one point.
Decision plan_several_contacts(const PlanInput& q);

/// Bounds on the bounces of a ball on one half-space.
struct BounceRange {
  double rest = detail::infinite;  ///< it does not come to rest before this time, s, rounded down
  double hits = 0;                 ///< at most so many impacts in the whole duration, rounded up
  double late = 0;  ///< error by lateness of all impacts together, for each second of step, m/s
};

/// The bounces of a ball whose only partner is a half-space, by its normal motion alone: friction
/// and rotation do not change that. Flight k takes 2 eᵏ w/g, so all end at t₁ + 2 e w/(g (1 − e)).
/// @return nothing proven (rest 0, hits and late ∞) for a ball that starts on the half-space, for
/// compliant contacts, or beyond a million impacts
BounceRange bounce_range(const PlanInput& q, const PairBound& pair);

/// The worst of all bounces, if each moving body has one half-space as its only partner; otherwise
/// nothing proven.
BounceRange worst_bounces(const PlanInput& q);

/// No ball that has one hard half-space as its only partner, and starts apart from it, rests before
/// this time. Other pairs are not included.
/// @return s; ∞ if there is no such ball
double earliest_rest(const PlanInput& q);

/// The proofs that no contact lasts and carries a force.
///
/// Without gravity no force presses bodies together, except a rotating body that pushes another
/// along: a ball on a rotating rod. Elastic balls leave with the normal speed with which they came.
/// That is 0 only in a graze. A parabola that grazes a half-space on which gravity presses would
/// have come from inside. (It may graze a fixed ball from outside and then be pressed onto it, if
/// it rises with exactly v² = g R cos θ.) Simultaneous hits are left to the rule on several
/// contacts. And a ball that bounces on one half-space does not rest before its last bounce. Each
/// hypothesis is in plan_hypotheses.hpp, with a scene that refutes the proof without it.
std::vector<Proof> resting_proofs(const PlanInput& q);

/// Whether gravity presses no bodies together: it is zero, or no fixed body may be met. Then all
/// bodies fall equally, and bodies that separate do not come back.
inline bool all_fall_equally(const PlanInput& q) {
  bool stands = false;
  for (const PairBound& pair : q.pairs) stands = stands || !pair.both_move;
  return !stands || !(gravity_felt(q) > 0);
}

/// The largest height of bounces that steps leave out where bodies may come to rest: half of the
/// rest of the error budget; if that is 0, the rounding of positions. Along each contact's normal
/// such a bounce is also shorter than a step: slowest_bounce() makes a speed of both.
/// @return m; 0: none is left out
double max_skipped_bounce(const PlanInput& q);

namespace detail {

/// How strongly gravity may press a pair together, m/s²: on a half-space up to rounding, 0 if it
/// pulls away.
inline double pair_pressing(const PlanInput& q, const PairBound& pair) {
  if (!pair.half_space) return q.bounds.gravity;
  const auto& wall = std::get<HalfSpaceShape>(q.scene->bodies[pair.b].shape);
  const double along = -wall.normal.dot(q.scene->gravity);
  return along > 16 * plan_u * q.bounds.gravity ? along : 0;
}

}  // namespace detail

/// Whether each resting body rests alone: a smooth ball on one hard half-space, which may otherwise
/// meet only smooth hard walls perpendicular to it. Then the tangential motion does not depend on
/// the normal motion: a ball that rests or sleeps too early is wrong by what that leaves out, and
/// no more.
/// @param lasts of a pair: whether leaving something out there counts
template <class Lasts>
bool rests_alone(const PlanInput& q, const Lasts& lasts) {
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

/// Resting contact is off if one of resting_proofs() holds. On, steps leave out bounces no higher
/// than max_skipped_bounce(): a ball that rests instead of bouncing is displaced by the height of
/// the bounce, and all later bounces are lower. That is a bound if rests_alone(). Where bodies lie
/// on or hit each other, or have friction, a bounce that is left out may change what comes after,
/// and the plan says that there is no bound.
Decision plan_resting(const PlanInput& q);

/// The error that sleep may make: half of the tolerance, or the rest of the error budget if that is
/// less.
inline double sleeping_share(const PlanInput& q) {
  return std::min(q.tolerance_left, q.tolerance / 2);
}

/// Sleeping is off where nothing rests. Leaving it off is never wrong; it only costs time. On, it
/// takes sleeping_share(): a body may sleep if it would not move farther in the whole duration T at
/// its speed s, or at the acceleration that gave it s within sleep_after: s T and s T²/τ. That is a
/// bound if rests_alone(), where the force is constant. It is none for a balanced body: a body on
/// its edge falls ever faster. A body that only falls is never slow for so long.
Decision plan_sleeping(const PlanInput& q);

/// The speed below which a body may sleep, m/s.
/// @param sleeping the decision on it
inline double sleep_speed(const PlanInput& q, const Decision& sleeping) {
  const double t = q.scene->duration;
  return sleeping.error > 0 ? sleeping_share(q) / std::max(t, t * t / sleep_after) : 0;
}

/// What can be missed between two steps of length h, if contacts are tested at steps only.
/// @param h s
std::vector<Inequality> tunnelling_conditions(const PlanInput& q, double h);

/// Continuous detection is off if nothing can pass through anything between two steps, and late and
/// missed hits stay within the tolerance.
Decision plan_continuous_detection(const PlanInput& q, double h);

namespace detail {

/// The space that moving bodies have: between level walls where there are any, otherwise their
/// bounding box.
struct Room {
  Vector3<double> size = Vector3<double>::Zero();  ///< m
  double widest = 0;                               ///< largest diameter of a moving body, m
  double mean = 0;                                 ///< mean diameter, m
  std::array<bool, 3> walled{};                    ///< on both sides, by axis
};

Room room_of(const Scene& scene);

}  // namespace detail

/// Cost of finding near pairs in one substep, by cells and by comparing all, without the bounding
/// boxes that both need.
struct PairSearchCost {
  double all = 0;    ///< instructions
  double cells = 0;  ///< instructions
};

/// The same counts as in chapter 10: pairs, entries in cells, pairs near enough to be compared.
/// Sorting takes half as many steps for an entry as its number has binary digits, and one more
/// visit.
/// @param boxes in an order that does not depend on the scene's
PairSearchCost pair_search_cost(std::span<const Aabb<double>> boxes);

namespace detail {

/// Boxes that bound all bounded bodies during a first step: of their bounding balls. Sorted, so
/// that the scene's order changes nothing. None if one is too large.
std::vector<Aabb<double>> first_boxes(const Scene& scene, double h);

}  // namespace detail

/// A broad phase never changes a result, so this is a question of cost alone.
Decision plan_broad_phase(const PlanInput& q);

/// The condition that every angular velocity is constant between impacts, so that orientations have
/// a formula.
Inequality rotation_is_constant(const PlanInput& q);

/// The conditions of an event-driven run: smooth hard balls, half-spaces and fixed balls, and
/// bodies that meet nothing and rotate at constant angular velocity.
std::vector<Inequality> event_conditions(const PlanInput& q);

/// The shortest flight that an event-driven run follows for a tolerance of positions: a bounce
/// under g that takes t rises by g t²/8.
/// @return s; half of the tolerance is used
inline double contact_time_cutoff(double tolerance, double gravity) {
  return std::sqrt(4 * tolerance / gravity);
}

/// Event-driven only where the number of events is bounded.
///
/// Finitely many elastic balls have finitely many hits (Vaserstein 1979, also Galperin 1981 and
/// Illner 1989; Burago, Ferleger and Kononenko 1998 with a bound by number and masses alone), and
/// with walls and gravity finitely many in a finite time (Galperin 1981), as long as nothing rests.
/// The bounces of a ball on one half-space are counted. A pair that flies freely meets once. A ball
/// that comes to rest on one half-space is followed until its bounces are shorter than a cutoff;
/// their height is the error. No other error is accepted with it: the other effects that may be
/// left out within the tolerance are those of bodies that touch nothing or go step by step.
/// Everything else goes step by step, which is always safe.
Decision plan_event_driven(const PlanInput& q);

namespace detail {

/// The default step: a frame.
inline double frame_step(const Scene& scene) {
  double h = std::min(1.0 / 60, scene.duration);
  if (scene.output.every > 0) h = std::min(h, scene.output.every);
  return h;
}

}  // namespace detail

/// The largest step that keeps the tolerance although contacts are tested at steps only; a frame
/// where no step is proven to, because then impacts are found between steps. The same where it
/// would take more than a thousand steps a frame: finding impacts costs less. A spring of angular
/// frequency ω takes at least 10 steps for each radian: h ≤ 1/(10 ω), far inside the stability
/// limit h ω < 2 of semi-implicit Euler. While it may push, longest_spring_substep() divides the
/// step further.
/// @return s
double step_from_tolerance(const PlanInput& q);

/// The step size as a decision: on with its value, or off from event to event.
Decision plan_step_size(const PlanInput& q, const PlanOptions& options);

/// Float suffices if nothing touches anything, angular velocities are constant, and the rounding of
/// a flight is within the rest of the error budget. In x + (v t + g t²/2) no term goes through more
/// than 8 roundings, each off by at most u of the sum of the terms' sizes. A rotation by ω t is
/// wrong by at most 32 u (1 + |ω| t), which moves a point by that times its distance. Without
/// gravity a term is missing, and the rest is rounded no worse. Squares of times and angular
/// velocities must neither overflow nor underflow in float. After a hit rounding errors may grow,
/// and nothing is proven.
Decision plan_double_precision(const PlanInput& q);

namespace detail {

/// No touch happens before this time; 0 for a crowd, whose pairs are not tested one by one.
double first_touch(const PlanInput& q);

}  // namespace detail

/// Until when positions can be predicted.
/// @param turning whether the plan has rotation
Decision plan_horizon(const PlanInput& q, bool turning);

// [expected-run]
/// The expected numbers in a run. Sums over pairs are taken in order of size, so that the order of
/// a scene's bodies changes nothing.
struct ExpectedRun {
  double movers = 0;     ///< bodies that move
  double bounded = 0;    ///< bodies other than half-spaces
  double walls = 0;      ///< half-spaces
  double hits = 0;       ///< impacts
  double wall_hits = 0;  ///< impacts on half-spaces, of these
  double crossings = 0;  ///< from cell to cell, from event to event
  double occupancy = 0;  ///< balls in a cell there
  double steps = 0;      ///< of time
  double substeps = 0;   ///< substeps, into which impacts and springs divide them
  double awake = 1;      ///< share of the time in which not all bodies sleep
  // Of pairs that stay in contact, the mean number at any time:
  double touching = 0;             ///< pairs
  double contacts = 0;             ///< their points
  double unpressed = 0;            ///< pairs that nothing presses together, of these
  double gaps = 0;                 ///< cost of finding these points, instructions
  double impact = 0;               ///< cost of finding when a pair comes to touch, instructions
  double spring_substeps = 0;      ///< substeps in which a spring pushes
  double gyroscopic_substeps = 0;  ///< substeps of rotations with the gyroscopic term
  PairSearchCost search;           ///< of each substep
  bool cells = false;              ///< balls test their neighbours only, from event to event
  bool heap = false;               ///< the number of contacts is assumed: three a body in a heap
};
// [/expected-run]

/// The expected numbers in a run of the scene.
/// @param h of a step, s
/// @param spring_substep length of a substep while a spring pushes, s; 0: none does
/// @param sleeps whether bodies at rest may sleep
ExpectedRun expected_run(const PlanInput& q, double h, double spring_substep, bool sleeps);

/// Estimates what each effect costs in this run, compared with a run without it. Overrides are not
/// included, except of events or steps.
/// @param h of a step, or of the step that would be taken, s
void estimate_savings(const PlanInput& q, double h, Plan& plan);

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
