/// @file
/// From a scene and its plan to the run that simulates it, and the quantities that a scene expects,
/// measured on a run.
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
#include <contact/plan/plan_types.hpp>
#include <contact/quaternion.hpp>
#include <contact/scene/scene.hpp>
#include <contact/scene/scene_run.hpp>
#include <contact/signed_distance.hpp>
#include <contact/vector.hpp>

namespace contact {

/// A quantity that a scene expects, at the present time of a run. Names and units as in
/// scene_quantities.
/// @return in SI units; not a number if it names a body that does not exist
double scene_quantity(const Scene& scene, const SceneRun& run, const SceneExpectation& wanted);

/// A scene without the effects that are forced off: gravity, friction, restitution, springs.
/// Effects that the planner has proven inactive stay, since they change nothing.
Scene scene_without_effects(Scene scene, const Plan& plan);

/// An event-driven run that goes on step by step where events do not end, or where their budget is
/// used up; fallback() says so.
class FallbackRun final : public SceneRun {
 public:
  /// @param scene of hard, smooth balls
  /// @param overrides for the plan of the stepped run
  /// @param compose makes a run of hard balls
  /// @param event_budget hits, after which it goes on step by step
  /// @param cutoff s; shorter bounces are left out; 0: those that time hardly resolves
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

  void report_unfinished(SceneObserver& observer) const override {
    if (!steps_) return;
    Later later(fallback_->time, &observer);
    steps_->report_unfinished(later);
  }

  double now() const override { return steps_ ? fallback_->time + steps_->now() : events_->now(); }
  Vector3<double> position(std::size_t body) const override { return seen().position(body); }
  Quaternion<double> orientation(std::size_t body) const override {
    return seen().orientation(body);
  }
  Vector3<double> velocity(std::size_t body) const override { return seen().velocity(body); }
  Vector3<double> angular_velocity(std::size_t body) const override {
    return seen().angular_velocity(body);
  }
  double energy() const override { return seen().energy(); }
  SceneRunCounts counts() const override;
  /// The effects of hard balls of which it is composed until it falls back.
  const HardSphereEffects& effects() const { return events_->effects(); }
  std::size_t bytes() const override { return seen().bytes(); }
  std::size_t bytes_per_body() const override { return seen().bytes_per_body(); }

  /// Of a run that has fallen back: first the positions and velocities at that time.
  SceneCheckpoint checkpoint() const override;
  void restore(const SceneCheckpoint& from) override;

 private:
  /// Reports hits with the time of the whole run.
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

  void switch_to_steps(SceneFallback fallback, Scene from);

  Scene scene_;
  Overrides overrides_;
  std::uint64_t event_budget_;
  double cutoff_;
  std::unique_ptr<HardSphereSceneRun> events_;
  std::unique_ptr<SceneRun> steps_;  // since it goes step by step
  std::optional<SceneFallback> fallback_;
  SceneRunCounts before_;  // until then
  Scene from_;             // at that time
};

/// The run that a plan decides on: a formula for bodies that fly freely; event-driven where the
/// plan says so and the scene is one of hard, smooth balls; otherwise step by step, with the stages
/// that are on.
/// @param scene checked; its run keeps its names and shapes
/// @param plan as plan_scene() makes it, overrides included
/// @param compose makes a run of hard balls
/// @param event_budget hits, after which an event-driven run goes on step by step
std::unique_ptr<SceneRun> make_scene_run(
    const Scene& scene, const Plan& plan, ComposeHardSpheres compose,
    std::uint64_t event_budget = std::numeric_limits<std::uint64_t>::max());

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/make_scene_run.cpp"
#endif
