/// @file
/// From a scene and its plan to the run that simulates it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <contact/free_flight_run.hpp>
#include <contact/hard_sphere_scene_run.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/plan.hpp>
#include <contact/plan_types.hpp>
#include <contact/scene.hpp>
#include <contact/scene_run.hpp>
#include <contact/stepped_run.hpp>

namespace contact {

// [without-effects]
/// A scene without what somebody has forced off: gravity, friction, restitution, springs. What the
/// planner has proven inactive stays: it changes nothing.
inline Scene scene_without_effects(Scene scene, const Plan& plan) {
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
/// A run from event to event that goes on step by step where events do not end, or where a budget
/// of them runs out: visibly, with fallback().
class FallbackRun final : public SceneRun {
 public:
  /// @param scene of hard, smooth balls
  /// @param overrides for the plan of the stepped run
  /// @param compose what makes a run of hard balls
  /// @param event_budget hits, after which it goes on step by step
  /// @param cutoff s; shorter hops are left out; 0: those that time can hardly tell
  FallbackRun(Scene scene, Overrides overrides, ComposeHardSpheres compose,
              std::uint64_t event_budget, double cutoff = 0)
      : scene_(std::move(scene)),
        overrides_(std::move(overrides)),
        event_budget_(event_budget),
        cutoff_(cutoff),
        events_(std::make_unique<HardSphereSceneRun>(scene_, compose, cutoff)) {}

  /// @cond
  using SceneRun::advance;
  /// @endcond
  bool event_driven() const override { return !steps_; }
  double step() const override { return steps_ ? steps_->step() : 0; }
  std::vector<SceneStage> stages() const override { return seen().stages(); }
  std::optional<SceneFallback> fallback() const override { return fallback_; }

  SceneRunEnd advance(double until, std::uint64_t budget, SceneObserver* observer) override {
    if (!steps_) {
      const std::uint64_t done = events_->counts().hits;
      const std::uint64_t left = event_budget_ - std::min(event_budget_, done);
      const SceneRunEnd end = events_->advance(until, std::min(budget, left), observer);
      const bool spent =
          end == SceneRunEnd::out_of_budget && events_->counts().hits >= event_budget_;
      if (end != SceneRunEnd::endless_hits && !spent) return end;
      std::string why = "the budget of " + std::to_string(event_budget_) + " hits ran out";
      if (!spent) {
        const SceneRunCounts counts = events_->counts();
        why = scene_.bodies[counts.endless_first].name + " hits " +
              scene_.bodies[counts.endless_second].name + " again and again without time going on";
      }
      Scene from = scene_;
      for (std::size_t i = 0; i < from.bodies.size(); ++i) {
        from.bodies[i].position = events_->position(i);
        from.bodies[i].velocity = events_->velocity(i);
      }
      go_over({events_->now(), why}, std::move(from));
    }
    Later later(fallback_->time, observer);
    return steps_->advance(until - fallback_->time, budget, observer == nullptr ? nullptr : &later);
  }

  void tell_unfinished(SceneObserver& observer) const override {
    if (!steps_) return;
    Later later(fallback_->time, &observer);
    steps_->tell_unfinished(later);
  }

  double now() const override { return steps_ ? fallback_->time + steps_->now() : events_->now(); }
  Vector3<double> position(std::size_t body) const override { return seen().position(body); }
  Rotor<double> orientation(std::size_t body) const override { return seen().orientation(body); }
  Vector3<double> velocity(std::size_t body) const override { return seen().velocity(body); }
  Vector3<double> spin(std::size_t body) const override { return seen().spin(body); }
  double energy() const override { return seen().energy(); }
  SceneRunCounts counts() const override {
    if (!steps_) return events_->counts();
    SceneRunCounts counts = before_;
    const SceneRunCounts more = steps_->counts();
    counts.steps = more.steps;
    counts.parts = more.parts;
    counts.crowded_steps = more.crowded_steps;
    counts.most_impacts = more.most_impacts;
    counts.hits += more.hits;
    counts.pairs = more.pairs;
    counts.contacts = more.contacts;
    counts.sweeps = more.sweeps;
    counts.rests += more.rests;
    counts.largest_overlap = std::max(counts.largest_overlap, more.largest_overlap);
    return counts;
  }
  /// Of which effects of hard balls it is composed until it goes over.
  const HardSphereEffects& effects() const { return events_->effects(); }
  std::size_t bytes() const override { return seen().bytes(); }
  std::size_t bytes_per_body() const override { return seen().bytes_per_body(); }

  /// Of a run that has gone over: first the places and velocities with which it did.
  SceneCheckpoint checkpoint() const override {
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
  void restore(const SceneCheckpoint& from) override {
    if (!from.fallback) {
      steps_.reset();
      fallback_.reset();
      events_->restore(from);
      return;
    }
    const std::size_t prefix = 6 * scene_.bodies.size() + 5;
    if (from.kind != "stepped after events" || from.numbers.size() < prefix)
      throw_invalid_argument("from", "a checkpoint of kind " + from.kind,
                             "must be one of this run");
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
    go_over(*from.fallback, std::move(scene));
    before_ = before;
    SceneCheckpoint rest = from;
    rest.kind = "stepped";
    rest.numbers.erase(rest.numbers.begin(),
                       rest.numbers.begin() + static_cast<std::ptrdiff_t>(prefix));
    steps_->restore(rest);
  }

 private:
  /// Tells of hits with the time of the whole run.
  class Later final : public SceneObserver {
   public:
    Later(double begin, SceneObserver* to) : begin_(begin), to_(to) {}
    bool on_hit(const SceneHit& hit) override {
      SceneHit later = hit;
      later.time += begin_;
      return to_->on_hit(later);
    }

   private:
    double begin_;
    SceneObserver* to_;
  };

  const SceneRun& seen() const { return steps_ ? *steps_ : static_cast<const SceneRun&>(*events_); }

  void go_over(SceneFallback fallback, Scene from) {
    before_ = events_->counts();
    fallback_ = std::move(fallback);
    from_ = std::move(from);
    from_.duration = std::max(scene_.duration - fallback_->time, scene_.duration / 1024);
    // Half of the tolerance went to the hops that were left out.
    if (cutoff_ > 0 && from_.tolerance.position) *from_.tolerance.position /= 2;
    PlanOptions options;
    options.overrides = overrides_;
    steps_ = make_stepped_run(from_, plan_scene(from_, options));
  }

  Scene scene_;
  Overrides overrides_;
  std::uint64_t event_budget_;
  double cutoff_;
  std::unique_ptr<HardSphereSceneRun> events_;
  std::unique_ptr<SceneRun> steps_;  // from when on it goes step by step
  std::optional<SceneFallback> fallback_;
  SceneRunCounts before_;  // until then
  Scene from_;             // as it was then
};
// [/fallback-run]

// [make-scene-run]
/// The run that a plan decides on: a formula for what flies freely; from event to event where the
/// plan says so and the scene is one of hard, smooth balls; step by step otherwise, with the stages
/// that are on.
/// @param scene checked; what names and shapes it has, its run keeps
/// @param plan as plan_scene() makes it, overrides included
/// @param compose what makes a run of hard balls
/// @param event_budget hits, after which a run from event to event goes on step by step
/// @throws std::invalid_argument with what stepped_refusal() says, if neither can run it
inline std::unique_ptr<SceneRun> make_scene_run(
    const Scene& scene, const Plan& plan, ComposeHardSpheres compose,
    std::uint64_t event_budget = std::numeric_limits<std::uint64_t>::max()) {
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
