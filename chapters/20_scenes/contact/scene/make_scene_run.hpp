/// @file
/// What a scene expects, measured on a run of it.
/// From a scene and its plan to the run that simulates it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include <contact/contact_solver.hpp>
#include <contact/events/hard_sphere_run.hpp>
#include <contact/events/hard_sphere_scene.hpp>
#include <contact/gap.hpp>
#include <contact/plan/plan_types.hpp>
#include <contact/rotation.hpp>
#include <contact/scene/scene.hpp>
#include <contact/scene/scene_run.hpp>
#include <contact/vector.hpp>

namespace contact {

/// A quantity that a scene expects, as a run has it now. Names and units as in scene_quantities.
/// @return in SI units; not a number if it names a body that is not there
double scene_quantity(const Scene& scene, const SceneRun& run, const SceneExpectation& wanted);

/// A scene without what somebody has forced off: gravity, friction, restitution, springs. What the
/// planner has proven inactive stays: it changes nothing.
Scene scene_without_effects(Scene scene, const Plan& plan);

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
              std::uint64_t event_budget, double cutoff = 0);

  /// @cond
  using SceneRun::advance;
  /// @endcond
  bool event_driven() const override { return !steps_; }
  double step() const override { return steps_ ? steps_->step() : 0; }
  std::vector<SceneStage> stages() const override { return seen().stages(); }
  std::optional<SceneFallback> fallback() const override { return fallback_; }

  SceneRunEnd advance(double until, std::uint64_t budget, SceneObserver* observer) override;

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
  SceneRunCounts counts() const override;
  /// Of which effects of hard balls it is composed until it goes over.
  const HardSphereEffects& effects() const { return events_->effects(); }
  std::size_t bytes() const override { return seen().bytes(); }
  std::size_t bytes_per_body() const override { return seen().bytes_per_body(); }

  /// Of a run that has gone over: first the places and velocities with which it did.
  SceneCheckpoint checkpoint() const override;
  void restore(const SceneCheckpoint& from) override;

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

  void go_over(SceneFallback fallback, Scene from);

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

/// The run that a plan decides on: a formula for what flies freely; from event to event where the
/// plan says so and the scene is one of hard, smooth balls; step by step otherwise, with the stages
/// that are on.
/// @param scene checked; what names and shapes it has, its run keeps
/// @param plan as plan_scene() makes it, overrides included
/// @param compose what makes a run of hard balls
/// @param event_budget hits, after which a run from event to event goes on step by step
/// @throws std::invalid_argument with what stepped_refusal() says, if neither can run it
std::unique_ptr<SceneRun> make_scene_run(
    const Scene& scene, const Plan& plan, ComposeHardSpheres compose,
    std::uint64_t event_budget = std::numeric_limits<std::uint64_t>::max());

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/make_scene_run.cpp"
#endif
