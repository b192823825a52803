#include <contact/plan/plan_rules.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <contact/plan/plan_bounds.hpp>
#include <contact/plan/plan_types.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/scene/scene.hpp>
#include <contact/vector.hpp>

namespace contact {

// [error-budget]
/// Compares an error with the rest of the error budget.
///
/// Errors add up: errors of a and then b make at most a + b. So the tolerance is a bound on their
/// sum, and a rule may take only what the earlier ones have left.
/// @param error of the effect in question, m
CONTACT_SCENES_INLINE Inequality fits_tolerance(const PlanInput& q, std::string error_is,
                                                double error) {
  return {std::move(error_is),
          error,
          Relation::at_most,
          q.tolerance_left,
          q.tolerance_left == q.tolerance ? "tolerance of a position" : "rest of the error budget",
          "m"};
}

/// Subtracts the error that a decision accepts, rounded down: so the exact sum of all accepted
/// errors is at most the tolerance. An error without a bound subtracts nothing: no share would
/// suffice.
CONTACT_SCENES_INLINE void spend_tolerance(PlanInput& q, const Decision& decision) {
  if (decision.error > 0 && std::isfinite(decision.error))
    q.tolerance_left = std::max(0.0, detail::rounded_down(q.tolerance_left - decision.error));
}
// [/error-budget]

/// The error that a rule takes if it may choose: half of the rest, so that others get a share.
CONTACT_SCENES_INLINE double budget_share(const PlanInput& q) { return q.tolerance_left / 2; }

CONTACT_SCENES_INLINE Inequality nothing_meets(const PlanInput& q) {
  return {"pairs of bodies that may meet",
          pairs_that_may_meet(q.bounds),
          Relation::equal,
          0,
          "none, so all bodies fly freely",
          ""};
}

// [rotation-rule]
CONTACT_SCENES_INLINE Proof smooth_balls(const PlanInput& q) {
  return {
      "The contact force on a smooth ball acts through its centre, without torque; a body that "
      "touches nothing and does not rotate keeps its orientation.",
      {{"moving bodies other than balls that may touch something", touching_non_balls(q),
        Relation::equal, 0, "none", ""},
       {"moving bodies other than balls that rotate", q.motion.rotating, Relation::equal, 0, "none",
        ""},
       {"largest friction between bodies that may meet", max_friction(q.pairs), Relation::equal, 0,
        "smooth", ""}}};
}
// [/rotation-rule]

namespace detail {

/// Whether reflection in a plane through its centre perpendicular to an axis maps a body to itself.
CONTACT_SCENES_INLINE bool is_mirrored(const SceneBody& body, int axis) {
  if (is_ball(body)) return true;
  if (const auto* wall = std::get_if<HalfSpaceShape>(&body.shape)) return wall->normal(axis) == 0;
  if (std::holds_alternative<HullShape>(body.shape)) return false;
  for (int k = 0; k < 3; ++k) {
    if (k != axis && body.orientation.v(k) != 0) return false;
  }
  return true;
}

/// The distance, along an axis, of the mirror planes of two bodies that may meet. A ball beside a
/// fixed box that spans its height shares the plane: the box's nearest point is level with the
/// ball's centre.
CONTACT_SCENES_INLINE double mirrors_apart(const SceneBody& a, const SceneBody& b, int axis) {
  if (is_half_space(b)) return 0;
  const double apart = std::abs(a.position(axis) - b.position(axis));
  const auto* box = std::get_if<BoxShape>(&b.shape);
  if (!b.moves && box != nullptr && is_ball(a)) return apart < box->half_lengths(axis) ? 0 : apart;
  return apart;
}

CONTACT_SCENES_INLINE double mirrors_apart_in(const PlanInput& q, const PairBound& pair, int axis) {
  const Scene& scene = *q.scene;
  if (!pair.crowd) return mirrors_apart(scene.bodies[pair.a], scene.bodies[pair.b], axis);
  if (pair.half_space) return 0;
  if (pair.both_move) {
    // The farthest from one of them is at an end.
    const double from = scene.bodies[pair.b].position(axis);
    return std::max(std::abs(q.motion.low(axis) - from), std::abs(q.motion.high(axis) - from));
  }
  double most = 0;
  for (const SceneBody& body : scene.bodies) {
    if (body.moves) most = std::max(most, mirrors_apart(body, scene.bodies[pair.b], axis));
  }
  return most;
}

}  // namespace detail

/// The conditions for a scene to be its own mirror image in a plane perpendicular to an axis.
///
/// The laws of motion are symmetric under reflection. So a scene that a reflection maps to itself,
/// body by body, stays so: no velocity and no force ever has a component along the axis, and no
/// angular velocity one perpendicular to it. All comparisons are exact: one ulp of velocity, and
/// there is motion out of the plane.
/// @param axis 0, 1 or 2: x, y or z
CONTACT_SCENES_INLINE std::vector<Inequality> mirror_conditions(const PlanInput& q, int axis) {
  const Scene& scene = *q.scene;
  const bool smooth = is_proven(smooth_balls(q));
  const double velocity = q.motion.velocity(axis);
  const double angular_velocity = smooth ? 0 : q.motion.angular_velocity(axis);
  double asymmetric = q.motion.asymmetric(axis);
  double apart = 0;
  for (const PairBound& pair : q.pairs) {
    if (!pair.both_move && !detail::is_mirrored(scene.bodies[pair.b], axis)) asymmetric += 1;
    apart = std::max(apart, detail::mirrors_apart_in(q, pair, axis));
  }
  const std::string name = axis_name(axis);
  const double pull = q.table == axis ? 0.0 : std::abs(scene.gravity(axis));
  const auto along = [&](std::string_view id, double left, const std::string& words) {
    Inequality condition = required(q, id, left);
    condition.left_is = words;
    return condition;
  };
  // [mirror]
  return {
      along("mirror/no-gravity", pull,
            "gravity along " + name + (q.table == axis ? " that the table does not cancel" : "")),
      along("mirror/no-velocity", velocity, "fastest motion along " + name + " at the beginning"),
      along("mirror/no-rotation", angular_velocity,
            "largest angular velocity about another axis than " + name),
      along("mirror/mirrored-shapes", asymmetric,
            "bodies or pairs not their own mirror image across " + name),
      along("mirror/common-plane", apart,
            "farthest that centres of bodies that may meet differ along " + name)};
  // [/mirror]
}

CONTACT_SCENES_INLINE Proof line_motion(const PlanInput& q, int along) {
  const int first = (along + 1) % 3;
  const int second = (along + 2) % 3;
  Proof proof{"The scene is its own mirror image across " + axis_name(first) + " and across " +
                  axis_name(second) + ", so that all motion is along " + axis_name(along) +
                  " and nothing rotates.",
              mirror_conditions(q, first)};
  for (Inequality& condition : mirror_conditions(q, second))
    proof.conditions.push_back(std::move(condition));
  return proof;
}

CONTACT_SCENES_INLINE std::optional<Proof> proven_line(const PlanInput& q) {
  for (int along = 2; along >= 0; --along) {
    Proof proof = line_motion(q, along);
    if (is_proven(proof)) return proof;
  }
  return std::nullopt;
}

// [table]
CONTACT_SCENES_INLINE std::vector<Inequality> table_conditions(const PlanInput& q, int axis) {
  const Scene& scene = *q.scene;
  double off_table = 0;
  double soft = 0;
  bool balls = true;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const SceneBody& body = scene.bodies[i];
    if (!body.moves) continue;
    bool lies = false;
    const auto* ball = std::get_if<BallShape>(&body.shape);
    balls = balls && ball != nullptr;
    for (const std::size_t k : q.bounds.floors) {
      const SceneBody& floor = scene.bodies[k];
      const auto& plane = std::get<HalfSpaceShape>(floor.shape);
      if (ball == nullptr) continue;
      const double height = plane.normal(axis) * body.position(axis);
      if (detail::sign_of_rest(height, plane.offset, ball->radius) != 0) continue;
      lies = true;
      const PairMaterial pair =
          pair_material(scene.materials[body.material], scene.materials[floor.material]);
      soft += pair.stiffness ? 1 : 0;
    }
    off_table += lies ? 0 : 1;
  }
  return {{balls ? "balls that do not lie exactly on a level floor"
                 : "moving bodies other than balls that lie exactly on a level floor",
           off_table, Relation::equal, 0, "none", ""},
          {"balls that sink into their floor", soft, Relation::equal, 0, "none", ""},
          {"largest friction between bodies that may meet", max_friction(q.bounds.pairs),
           Relation::equal, 0, "smooth", ""}};
}

namespace detail {

/// The pairs without those of balls and the floor that cancels gravity.
CONTACT_SCENES_INLINE std::vector<PairBound> pairs_off_table(const Scene& scene,
                                                             const std::vector<PairBound>& pairs,
                                                             int axis) {
  std::vector<PairBound> rest;
  for (const PairBound& pair : pairs) {
    const auto* plane = std::get_if<HalfSpaceShape>(&scene.bodies[pair.b].shape);
    const bool table = plane != nullptr && level_axis(plane->normal) == axis &&
                       plane->normal(axis) * scene.gravity(axis) < 0;
    if (!table) rest.push_back(pair);
  }
  return rest;
}

}  // namespace detail

namespace detail {

CONTACT_SCENES_INLINE MotionRange motion_range(const Scene& scene, const SceneBounds& bounds) {
  MotionRange range;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const SceneBody& body = scene.bodies[i];
    if (!body.moves) continue;
    range.velocity = range.velocity.cwiseMax(body.velocity.cwiseAbs());
    range.low = range.low.cwiseMin(body.position);
    range.high = range.high.cwiseMax(body.position);
    const Vector3<double> rate = body.angular_velocity.cwiseAbs();
    for (int axis = 0; axis < 3; ++axis) {
      range.asymmetric(axis) += is_mirrored(body, axis) ? 0 : 1;
      range.angular_velocity(axis) =
          std::max({range.angular_velocity(axis), rate((axis + 1) % 3), rate((axis + 2) % 3)});
    }
    if (is_ball(body)) continue;
    range.rotating += body.angular_velocity.isZero(0) ? 0 : 1;
    range.touching += bounds.bodies[i].disturbed ? 1 : 0;
  }
  return range;
}

}  // namespace detail

CONTACT_SCENES_INLINE PlanInput plan_input(const Scene& scene, std::vector<std::string> dropped) {
  PlanInput q;
  q.dropped = std::move(dropped);
  q.scene = &scene;
  q.bounds = scene_bounds(scene);
  q.motion = detail::motion_range(scene, q.bounds);
  q.pairs = q.bounds.pairs;
  // If the order of events is required, no position error is allowed: it may swap two events.
  if (!scene.tolerance.event_order) q.tolerance = scene.tolerance.position.value_or(0);
  q.tolerance_left = q.tolerance;
  const int axis = detail::only_axis(scene.gravity);
  if (axis < 0 || q.bounds.movers == 0 || !is_proven({"", table_conditions(q, axis)})) return q;
  q.table = axis;
  q.pairs = detail::pairs_off_table(scene, q.bounds.pairs, axis);
  if (is_proven(plane_motion(q, axis))) return q;
  q.table = -1;
  q.pairs = q.bounds.pairs;
  return q;
}
// [/table]

/// An error that is not 0 counts as at least this, m, because its factors may underflow: if the
/// order of hits is required, an error of 0 is allowed, and the smallest other one is not.
inline constexpr double least_error = std::numeric_limits<double>::min();

/// Gravity is off if it is zero, if nothing moves, if a table cancels it, or if nothing touches
/// anything and free fall over the whole duration is within the rest of the error budget: ½ g T² is
/// then exactly the error. That also holds in a run without a gyroscopic term, or in float: no
/// contacts are tested, so rotation and rounding do not change the missing fall.
CONTACT_SCENES_INLINE Decision plan_gravity(const PlanInput& q) {
  const Scene& scene = *q.scene;
  std::vector<Proof> proofs{
      {"Without gravity its term adds zeros.",
       {{"size of gravity", q.bounds.gravity, Relation::equal, 0, "none", "m/s²"}}},
      {"Gravity accelerates only bodies that can move.",
       {{"moving bodies", static_cast<double>(q.bounds.movers), Relation::equal, 0, "none", ""}}}};
  const int axis = detail::only_axis(scene.gravity);
  if (axis >= 0) {
    Proof table{"A level table without friction balances gravity.", table_conditions(q, axis)};
    PlanInput on_table = q;
    on_table.table = axis;
    on_table.pairs = detail::pairs_off_table(scene, q.bounds.pairs, axis);
    for (Inequality& condition : mirror_conditions(on_table, axis))
      table.conditions.push_back(std::move(condition));
    proofs.push_back(std::move(table));
  }
  // [fall-proof]
  double fall = detail::rounded_up(q.bounds.gravity * scene.duration * scene.duration / 2);
  // The product may underflow to 0, but the error is not 0.
  if (q.bounds.gravity > 0) fall = std::max(fall, least_error);
  proofs.push_back(
      {"The error of a body that touches nothing is the fall that is left out, ½ g T².",
       {nothing_meets(q), fits_tolerance(q, "fall in the whole duration, ½ g T²", fall)},
       fall,
       "½ g T², the fall that is left out"});
  // [/fall-proof]
  return decide(Effect::gravity, std::move(proofs), "Gravity changes velocities.");
}

// [gyroscopic-rule]
CONTACT_SCENES_INLINE Decision plan_gyroscopic_term(const PlanInput& q) {
  const Scene& scene = *q.scene;
  double uneven = 0;
  double aside = 0;
  for (const SceneBody& body : scene.bodies) {
    if (!body.moves) continue;
    const MomentRange moments = moment_range(body.inertia);
    uneven = std::max(uneven, moments.max - moments.min);
    const double angular_velocity =
        moments.max / moments.min * body.angular_velocity.dot(body.angular_velocity);
    const double alpha = (moments.max - moments.min) / moments.min * angular_velocity;
    aside = std::max(aside, detail::rounded_up(rotation_radius(body.shape) * alpha *
                                               scene.duration * scene.duration / 2));
    if (rotation_radius(body.shape) > 0 && moments.max > moments.min &&
        !body.angular_velocity.isZero(0))
      aside = std::max(aside, least_error);
  }
  Proof still = smooth_balls(q);
  still.why = "Nothing rotates, or only as a ball does.";
  std::vector<Proof> proofs{
      {"If all moments of inertia of a body are equal, I ω is along ω, and ω × I ω = 0.",
       {{"largest difference between two moments of inertia of a body", uneven, Relation::equal, 0,
         "equal", "kg·m²"}}},
      std::move(still)};
  for (int axis = 2; axis >= 0; --axis) {
    Proof plane = plane_motion(q, axis);
    if (!is_proven(plane)) continue;
    plane.why = "Every angular velocity stays along " + axis_name(axis) +
                ", which mirror symmetry makes a principal axis of every body; there ω × I ω = 0.";
    proofs.push_back(std::move(plane));
  }
  proofs.push_back(
      {"The orientation of a body that touches nothing is wrong by at most ½ α T², α = |ω|² "
       "(I₃/I₁) (I₃ − I₁)/I₁.",
       {nothing_meets(q),
        fits_tolerance(q, "largest displacement of a body's point by that, R ½ α T²", aside)},
       aside,
       "R ½ α T², by which a body's points are displaced"});
  return decide(Effect::gyroscopic_term, std::move(proofs),
                "Not proven that every angular velocity is constant.");
}
// [/gyroscopic-rule]

}  // namespace contact
