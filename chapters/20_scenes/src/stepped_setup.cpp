#include "stepped_setup.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <contact/contact_solver.hpp>
#include <contact/inertia.hpp>
#include <contact/plan/plan_bounds.hpp>
#include <contact/plan/plan_rules.hpp>
#include <contact/plan/plan_types.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/scene/scene.hpp>
#include <contact/scene/scene_solids.hpp>
#include <contact/stepped/stage_contact_events.hpp>
#include <contact/stepped/stage_contacts.hpp>
#include <contact/stepped/stage_forces.hpp>
#include <contact/stepped/stage_impacts.hpp>
#include <contact/stepped/stage_motion.hpp>
#include <contact/stepped/stage_pairs.hpp>
#include <contact/stepped/stage_sleep.hpp>
#include <contact/stepped/stage_time_of_impact.hpp>
#include <contact/stepped/stepped_state.hpp>

namespace contact::detail {

/// The step: the plan's, or a frame where the plan is event-driven.
CONTACT_SCENES_INLINE double step_of(const Scene& scene, const Plan& plan) {
  if (plan.step > 0) return plan.step;
  double h = std::min(1.0 / 60, scene.duration);
  if (scene.output.every > 0) h = std::min(h, scene.output.every);
  return h;
}

// [kept-axes]
/// Along which axes the scene is its own mirror image. Rounding must not break the symmetry: along
/// such an axis nothing moves, and nothing rotates about another one.
CONTACT_SCENES_INLINE std::array<bool, 3> proven_mirrors(const PlanInput& q) {
  std::array<bool, 3> mirrors{};
  for (int axis = 0; axis < 3; ++axis)
    mirrors[static_cast<std::size_t>(axis)] = is_proven(plane_motion(q, axis));
  return mirrors;
}

/// The coordinates that change. If a dimension is off, the coordinate along the mirror's axis is
/// not stored; if it is on although a mirror is proven, it is stored and constant.
CONTACT_SCENES_INLINE ActiveAxes active_axes(const Plan& plan, const PlanInput& q,
                                             const std::array<bool, 3>& mirrors) {
  ActiveAxes active;
  const std::size_t least = is_on(plan, Effect::third_dimension)    ? 3
                            : is_on(plan, Effect::second_dimension) ? 2
                                                                    : 1;
  std::array<bool, 3> dropped{};
  for (std::size_t axis = 3; axis-- > 0 && active.count > least;) {
    dropped[axis] = mirrors[axis];
    if (mirrors[axis]) --active.count;
  }
  std::stable_partition(active.axes.begin(), active.axes.end(),
                        [&](int axis) { return !dropped[static_cast<std::size_t>(axis)]; });
  for (std::size_t k = 0; k < active.count; ++k)
    active.held[k] = mirrors[static_cast<std::size_t>(active.axes[k])] && active.axes[k] != q.table;
  return active;
}

/// The coordinates of angular velocities that change: a body that moves in a plane rotates about
/// the axis perpendicular to it. A smooth ball may rotate about another, at constant angular
/// velocity.
CONTACT_SCENES_INLINE ActiveAxes active_rotation_axes(const Scene& scene, const ActiveAxes& active,
                                                      const std::array<bool, 3>& mirrors) {
  ActiveAxes spins;
  std::array<bool, 3> forbidden{};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t axis = 0; axis < 3; ++axis)
      forbidden[k] = forbidden[k] || (mirrors[axis] && axis != k);
  for (const SceneBody& body : scene.bodies)
    for (std::size_t k = 0; k < 3; ++k)
      if (body.moves && forbidden[k] && body.angular_velocity(static_cast<int>(k)) != 0)
        return spins;
  if (active.count < 3) {
    spins.count = 3 - active.count;
    std::rotate_copy(active.axes.begin(),
                     active.axes.begin() + static_cast<std::ptrdiff_t>(active.count),
                     active.axes.end(), spins.axes.begin());
  }
  for (std::size_t k = 0; k < spins.count; ++k)
    spins.held[k] = forbidden[static_cast<std::size_t>(spins.axes[k])];
  return spins;
}
// [/kept-axes]

/// Sets half the thickness of hulls that may meet other bodies: the distance of the nearest face
/// from the origin, which is their centre of mass.
CONTACT_SCENES_INLINE void set_cores_of_hulls(SteppedSetup& setup) {
  for (SteppedBody& body : setup.bodies) {
    const auto* hull = std::get_if<HullVertices>(&body.shape);
    if (hull == nullptr) continue;
    const double inner = -origin_gap(hull->points);
    if (inner > 0) body.core = inner;
  }
}

// [stepped-setup]
/// The setup of a scene by its plan. An effect that is off is removed from the materials too:
/// without friction all are smooth, without restitution e is 0, without penalty contact all are
/// hard.
CONTACT_SCENES_INLINE SteppedSetup stepped_setup(const Scene& scene, const Plan& plan) {
  SteppedSetup setup;
  setup.scene = scene;
  setup.slot_of.resize(scene.bodies.size());
  for (const int kind : {0, 1, 2}) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const SceneBody& body = scene.bodies[i];
      const bool plane = std::holds_alternative<HalfSpaceShape>(body.shape);
      if ((plane ? 2 : body.moves ? 0 : 1) != kind) continue;
      setup.slot_of[i] = setup.bodies.size();
      setup.bodies.push_back(stepped_body(body, i));
    }
    if (kind == 0) setup.movers = setup.bodies.size();
    if (kind == 1) setup.bounded = setup.bodies.size();
  }
  if (setup.bounded > 1 && plan.pairs > 0) set_cores_of_hulls(setup);
  // The gyroscopic term changes angular velocities, so it includes rotation.
  setup.gyroscopic = is_on(plan, Effect::gyroscopic_term);
  setup.rotation = is_on(plan, Effect::rotation) || setup.gyroscopic;
  setup.continuous = is_on(plan, Effect::continuous_detection);
  setup.one_by_one = setup.movers <= max_one_by_one || plan.pairs == 0;
  const PlanInput q = plan_input(scene);
  const std::array<bool, 3> mirrors = proven_mirrors(q);
  setup.line = proven_line(q).has_value();
  setup.thinnest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < setup.bounded; ++i) {
    setup.thinnest = std::min(setup.thinnest, 2 * setup.bodies[i].core);
    setup.edges =
        setup.edges || (i < setup.movers && !setup.line && setup.bodies[i].rotation_radius > 0);
  }
  setup.max_impacts = max_impacts(setup.movers, setup.rotation && setup.edges);
  setup.together = is_on(plan, Effect::several_contacts);
  if (!is_on(plan, Effect::gravity)) setup.scene.gravity.setZero();
  setup.step = step_of(scene, plan);
  setup.active = active_axes(plan, q, mirrors);
  setup.active_rotation = active_rotation_axes(scene, setup.active, mirrors);
  setup.rotates.fill(false);
  for (std::size_t k = 0; k < setup.active_rotation.count; ++k)
    setup.rotates[static_cast<std::size_t>(setup.active_rotation.axes[k])] =
        !setup.active_rotation.held[k];

  double lightness = 0;
  for (std::size_t i = 0; i < setup.movers; ++i)
    lightness = std::max(lightness, 1 / setup.bodies[i].mass);
  double stiffest = 0;
  setup.smooth = true;
  for (const SceneMaterial& a : scene.materials) {
    for (const SceneMaterial& b : scene.materials) {
      PairMaterial pair = pair_material(a, b);
      if (!is_on(plan, Effect::friction)) pair.friction = 0;
      if (!is_on(plan, Effect::restitution)) pair.restitution = 0;
      if (!is_on(plan, Effect::penalty_contact)) pair.stiffness.reset();
      if (pair.stiffness) stiffest = std::max(stiffest, *pair.stiffness);
      setup.smooth = setup.smooth && pair.friction == 0;
      setup.material.push_back(pair);
    }
  }
  setup.spring_substep = setup.step;
  if (stiffest > 0)
    setup.spring_substep = std::min(setup.step, 1 / (128 * std::sqrt(stiffest * 2 * lightness)));

  if (plan.spring_substep > 0)
    setup.spring_substep = std::min(setup.spring_substep, plan.spring_substep);
  // The plan decides their shares of the tolerance.
  setup.rest_height = plan.rest_height;
  const double g = size_of(setup.scene.gravity);
  const double bounce = std::min(g * setup.step / 2, std::sqrt(2 * g * setup.rest_height));
  setup.slow_speed = std::max(bounce * 0x1p-20, 1e-11);
  setup.sleep_speed = plan.sleep_speed;
  // The residual of the iterations is at most a millionth of the speed that would add up to half
  // the tolerance in the whole duration.
  const double far = scene.tolerance.position.value_or(1e-6) / 2;
  const double slow = far / std::max(scene.duration, scene.duration * scene.duration / sleep_after);
  const double left = std::clamp(slow * 1e-6, 1e-13, 1e-9);
  setup.solver = setup.one_by_one ? SolverSettings<double>{400, left, 1.5}
                                  : SolverSettings<double>{400, 1e-7, 1.0};
  return setup;
}
// [/stepped-setup]

/// The stages that a plan needs. Without a pair that may meet there are no contacts at all.
CONTACT_SCENES_INLINE StepPipeline step_pipeline(const Plan& plan, const SteppedSetup& setup) {
  StepPipeline line;
  const auto add = [&](std::vector<NamedStage>& to, std::string name, std::string detail,
                       StepStage run) {
    to.push_back({{std::move(name), std::move(detail)}, run});
  };
  const bool meet = plan.pairs > 0;
  const bool cells = is_on(plan, Effect::broad_phase);
  const bool springs = is_on(plan, Effect::penalty_contact);
  const bool sleep = is_on(plan, Effect::sleeping);
  const bool forces = is_on(plan, Effect::resting) || !setup.one_by_one;
  const bool slides = forces && setup.one_by_one && !setup.smooth;
  const bool edges = forces && setup.one_by_one && passes_edges(setup);
  const std::string iterations =
      setup.together ? "all contacts of a body together" : "each on its own";
  // [pipeline]
  if (meet) {
    if (cells)
      add(line.substep, "broad phase", "cells", sort_into_cells);
    else
      add(line.substep, "pairs", "each with each", compare_all_pairs);
    add(line.substep, "contacts", "distances and contact points", find_touching_pairs);
    if (sleep) add(line.substep, "waking", "bodies that a fast body touches", wake_bodies);
    if (setup.one_by_one) add(line.substep, "impacts", iterations, solve_impacts);
    if (springs) add(line.substep, "springs", "leapfrog, dampers implicit", apply_spring_forces);
  }
  if (is_on(plan, Effect::gravity)) add(line.substep, "gravity", "even", add_gravity);
  if (meet) {
    // Where nothing rests it still stops approaches by rounding.
    add(line.substep, forces ? "contact forces" : "impacts left over",
        forces ? iterations : "rounding, and a step with too many to take one by one",
        solve_forces);
    if (slides) add(line.substep, "end of sliding", "by its rate", find_end_of_sliding);
    if (setup.continuous && setup.one_by_one)
      add(line.substep, "time of impact", "by conservative advancement", find_first_impact);
    if (edges) add(line.substep, "end of support", "by bisection", find_end_of_support);
  }
  // [/pipeline]
  if (meet) add(line.substep, "check of forces", "whether one varies", note_varying_forces);
  const bool bounce = meet && is_on(plan, Effect::restitution);
  if (bounce) add(line.substep, "bounces", "of impacts that are processed together", solve_bounces);
  add(line.substep, "motion", "exact for constant acceleration", move_bodies);
  if (setup.gyroscopic)
    add(line.substep, "rotation", "with the gyroscopic term", rotate_with_gyroscopic_term);
  else if (setup.rotation)
    add(line.substep, "rotation", "constant angular velocities", rotate_bodies);
  if (meet) {
    if (bounce) add(line.substep, "leaving", "what has bounced", apply_bounces);
    // A ball's impacts are found to the last bit in any orientation; an edge's are not.
    if ((setup.rotation && setup.edges) || !setup.one_by_one)
      add(line.substep, "pushing out", "half of each overlap at a time", correct_positions);
    if (sleep) add(line.after, "sleep", "groups that are slow", put_to_sleep);
  }
  return line;
}

}  // namespace contact::detail
