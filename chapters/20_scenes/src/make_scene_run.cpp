#include <contact/scene/make_scene_run.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <contact/contact_manifold.hpp>
#include <contact/contact_solver.hpp>
#include <contact/convex_shapes.hpp>
#include <contact/events/hard_sphere_scene.hpp>
#include <contact/inertia.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/plan/plan.hpp>
#include <contact/plan/plan_bounds.hpp>
#include <contact/plan/plan_types.hpp>
#include <contact/quaternion.hpp>
#include <contact/scene/compiled.hpp>
#include <contact/scene/free_flight_run.hpp>
#include <contact/scene/scene.hpp>
#include <contact/scene/scene_run.hpp>
#include <contact/signed_distance.hpp>
#include <contact/stepped/stage_contacts.hpp>
#include <contact/stepped/stepped_run.hpp>
#include <contact/stepped/stepped_state.hpp>
#include <contact/vector.hpp>

namespace contact {

namespace detail {

/// Energy, momentum or angular momentum of a body.
CONTACT_SCENES_INLINE double mechanical_quantity(const Scene& scene, const SceneRun& run,
                                                 std::size_t i, const std::string& quantity) {
  const SceneBody& body = scene.bodies[i];
  const Vector3<double> x = run.position(i);
  const Vector3<double> v = run.velocity(i);
  const Matrix3<double> turn = matrix_of(run.orientation(i));
  const Vector3<double> seen = turn.transpose() * run.angular_velocity(i);
  const Vector3<double> own = body.inertia * seen;
  const int axis = quantity.back() - 'x';
  if (quantity == "energy")
    return body.mass * v.dot(v) / 2 + seen.dot(own) / 2 - body.mass * scene.gravity.dot(x);
  if (quantity.starts_with("momentum")) return body.mass * v(axis);
  const Vector3<double> turning = turn * own;
  return Vector3<double>(x.cross(v) * body.mass + turning)(axis);
}

/// The smallest signed distance of a body to any other, negative where they overlap.
CONTACT_SCENES_INLINE double min_gap(const Scene& scene, const SceneRun& run, std::size_t i) {
  const auto shape = [&](std::size_t k) {
    return shape_in_world(stepped_body(scene.bodies[k], k), run.position(k), run.orientation(k));
  };
  const StepShape own = shape(i);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    if (k == i) continue;
    // Bodies whose centres are farther apart than this are not tested exactly.
    if (!is_half_space(scene.bodies[k])) {
      const Vector3<double> apart = run.position(k) - run.position(i);
      const double reach =
          outer_radius(scene.bodies[k].shape) + outer_radius(scene.bodies[i].shape);
      if (size_of(apart) - reach > least) continue;
    }
    least = std::min(least, signed_distance_of_shapes(own, shape(k)).distance);
  }
  return least;
}

}  // namespace detail

// [scene-quantity]
CONTACT_SCENES_INLINE double scene_quantity(const Scene& scene, const SceneRun& run,
                                            const SceneExpectation& wanted) {
  const std::string& quantity = wanted.quantity;
  if (quantity == "events") return static_cast<double>(run.counts().hits);
  const bool gap = quantity == "gap";
  const bool sum = quantity == "energy" || quantity.find("momentum") != std::string::npos;
  double result = gap ? std::numeric_limits<double>::infinity() : 0;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const SceneBody& body = scene.bodies[i];
    if (wanted.body.empty() ? !body.moves : body.name != wanted.body) continue;
    if (gap) {
      result = std::min(result, detail::min_gap(scene, run, i));
    } else if (sum) {
      if (body.moves) result += detail::mechanical_quantity(scene, run, i, quantity);
    } else {
      if (quantity == "speed") return size_of(run.velocity(i));
      const int axis = quantity.back() - 'x';
      if (quantity.starts_with("position")) return run.position(i)(axis);
      if (quantity.starts_with("velocity")) return run.velocity(i)(axis);
      return run.angular_velocity(i)(axis);
    }
  }
  return gap || sum ? result : std::numeric_limits<double>::quiet_NaN();
}
// [/scene-quantity]

// [without-effects]
CONTACT_SCENES_INLINE Scene scene_without_effects(Scene scene, const Plan& plan) {
  const auto forced_off = [&](Effect effect) {
    const Decision& decision = decision_on(plan, effect);
    return decision.overridden && !decision.on;
  };
  if (forced_off(Effect::gravity)) scene.gravity.setZero();
  for (SceneMaterial& material : scene.materials) {
    if (forced_off(Effect::friction)) material.friction = 0;
    if (forced_off(Effect::restitution)) material.restitution = 0;
    if (forced_off(Effect::penalty_contact)) material.stiffness.reset();
  }
  return scene;
}
// [/without-effects]

// [fallback-run]
CONTACT_SCENES_INLINE FallbackRun::FallbackRun(Scene scene, Overrides overrides,
                                               ComposeHardSpheres compose,
                                               std::uint64_t event_budget, double cutoff)
    : scene_(std::move(scene)),
      overrides_(std::move(overrides)),
      event_budget_(event_budget),
      cutoff_(cutoff),
      events_(std::make_unique<HardSphereSceneRun>(scene_, compose, cutoff)) {}

CONTACT_SCENES_INLINE SceneRunEnd FallbackRun::advance(double until, std::uint64_t budget,
                                                       SceneObserver* observer) {
  if (!steps_) {
    const std::uint64_t done = events_->counts().hits;
    const std::uint64_t left = event_budget_ - std::min(event_budget_, done);
    const SceneRunEnd end = events_->advance(until, std::min(budget, left), observer);
    const bool spent = end == SceneRunEnd::out_of_budget && events_->counts().hits >= event_budget_;
    if (end != SceneRunEnd::endless_hits && !spent) return end;
    std::string why = "the budget of " + std::to_string(event_budget_) + " hits ran out";
    if (!spent) {
      const SceneRunCounts counts = events_->counts();
      why = scene_.bodies[counts.endless_first].name + " hits " +
            scene_.bodies[counts.endless_second].name + " again and again at one instant";
    }
    Scene from = scene_;
    for (std::size_t i = 0; i < from.bodies.size(); ++i) {
      from.bodies[i].position = events_->position(i);
      from.bodies[i].velocity = events_->velocity(i);
    }
    switch_to_steps({events_->now(), why}, std::move(from));
  }
  Later later(fallback_->time, observer);
  return steps_->advance(until - fallback_->time, budget, observer == nullptr ? nullptr : &later);
}

CONTACT_SCENES_INLINE SceneRunCounts FallbackRun::counts() const {
  if (!steps_) return events_->counts();
  SceneRunCounts counts = before_;
  const SceneRunCounts more = steps_->counts();
  counts.steps = more.steps;
  counts.substeps = more.substeps;
  counts.crowded_steps = more.crowded_steps;
  counts.max_impacts = more.max_impacts;
  counts.hits += more.hits;
  counts.pairs = more.pairs;
  counts.contacts = more.contacts;
  counts.iterations = more.iterations;
  counts.rests += more.rests;
  counts.doubts.add(more.doubts, fallback_->time);
  counts.largest_overlap = std::max(counts.largest_overlap, more.largest_overlap);
  return counts;
}

CONTACT_SCENES_INLINE SceneCheckpoint FallbackRun::checkpoint() const {
  SceneCheckpoint to = seen().checkpoint();
  if (!steps_) return to;
  to.kind = "stepped after events";
  to.fallback = fallback_;
  std::vector<double> numbers;
  for (const SceneBody& body : from_.bodies) {
    for (int k = 0; k < 3; ++k) numbers.push_back(body.position(k));
    for (int k = 0; k < 3; ++k) numbers.push_back(body.velocity(k));
  }
  numbers.push_back(static_cast<double>(before_.hits));
  numbers.push_back(static_cast<double>(before_.crossings));
  numbers.push_back(static_cast<double>(before_.rests));
  numbers.push_back(before_.largest_overlap);
  numbers.push_back(before_.rest_error);
  numbers.insert(numbers.end(), to.numbers.begin(), to.numbers.end());
  to.numbers = std::move(numbers);
  return to;
}

CONTACT_SCENES_INLINE void FallbackRun::restore(const SceneCheckpoint& from) {
  if (!from.fallback) {
    steps_.reset();
    fallback_.reset();
    events_->restore(from);
    return;
  }
  const std::size_t prefix = 6 * scene_.bodies.size() + 5;
  if (from.kind != "stepped after events" || from.numbers.size() < prefix)
    throw_invalid_argument("from", "a checkpoint of kind " + from.kind, "must be one of this run");
  Scene scene = scene_;
  std::size_t at = 0;
  for (SceneBody& body : scene.bodies) {
    for (int k = 0; k < 3; ++k) body.position(k) = from.numbers[at++];
    for (int k = 0; k < 3; ++k) body.velocity(k) = from.numbers[at++];
  }
  SceneRunCounts before;
  before.hits = static_cast<std::uint64_t>(from.numbers[at++]);
  before.crossings = static_cast<std::uint64_t>(from.numbers[at++]);
  before.rests = static_cast<std::uint64_t>(from.numbers[at++]);
  before.largest_overlap = from.numbers[at++];
  before.rest_error = from.numbers[at++];
  switch_to_steps(*from.fallback, std::move(scene));
  before_ = before;
  SceneCheckpoint rest = from;
  rest.kind = "stepped";
  rest.numbers.erase(rest.numbers.begin(),
                     rest.numbers.begin() + static_cast<std::ptrdiff_t>(prefix));
  steps_->restore(rest);
}

CONTACT_SCENES_INLINE void FallbackRun::switch_to_steps(SceneFallback fallback, Scene from) {
  before_ = events_->counts();
  fallback_ = std::move(fallback);
  from_ = std::move(from);
  from_.duration = std::max(scene_.duration - fallback_->time, scene_.duration / 1024);
  // Half of the tolerance was spent on the bounces that are left out.
  if (cutoff_ > 0 && from_.tolerance.position) *from_.tolerance.position /= 2;
  PlanOptions options;
  options.overrides = overrides_;
  steps_ = make_stepped_run(from_, plan_scene(from_, options));
}
// [/fallback-run]

// [make-scene-run]
CONTACT_SCENES_INLINE std::unique_ptr<SceneRun> make_scene_run(const Scene& scene, const Plan& plan,
                                                               ComposeHardSpheres compose,
                                                               std::uint64_t event_budget) {
  Scene used = scene_without_effects(scene, plan);
  if (flies_freely(plan)) return make_free_flight_run(used, plan);
  if (!decision_on(plan, Effect::event_driven).on || hard_sphere_refusal(used))
    return make_stepped_run(used, plan);
  Overrides overrides;
  for (const Decision& decision : plan.decisions) {
    if (!decision.overridden || decision.effect == Effect::event_driven) continue;
    (decision.on ? overrides.with : overrides.without).push_back(decision.effect);
  }
  overrides.without.push_back(Effect::event_driven);
  return std::make_unique<FallbackRun>(std::move(used), std::move(overrides), compose, event_budget,
                                       plan.cutoff);
}
// [/make-scene-run]

}  // namespace contact
