/// @file
/// A run of hard balls from event to event, asked in terms of a scene's bodies.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <contact/hard_sphere_run.hpp>
#include <contact/hard_sphere_scene.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/scene.hpp>
#include <contact/scene_run.hpp>

namespace contact {

/// Makes the run of a setup: make_hard_spheres() of contact/hard_sphere_make.hpp, or another
/// that somebody has compiled already.
using ComposeHardSpheres = std::unique_ptr<HardSphereRun> (*)(const HardSphereSetup&);

// [hard-sphere-scene-run]
/// Hard, smooth balls of a scene. Spins and orientations stay as at first: nothing turns a smooth
/// ball.
class HardSphereSceneRun final : public SceneRun {
 public:
  /// @param scene for which hard_sphere_refusal() has nothing to say
  /// @param compose what makes the run
  /// @param cutoff s; shorter hops are left out; 0: those that time can hardly tell
  HardSphereSceneRun(const Scene& scene, ComposeHardSpheres compose, double cutoff = 0)
      : scene_(scene), balls_(hard_sphere_setup(scene)) {
    if (cutoff > 0) balls_.setup.cutoff = cutoff;
    run_ = compose(balls_.setup);
    ball_of_.assign(scene.bodies.size(), no_ball);
    for (std::size_t i = 0; i < balls_.ball_body.size(); ++i) ball_of_[balls_.ball_body[i]] = i;
  }

  bool event_driven() const override { return true; }
  double step() const override { return 0; }
  std::vector<SceneStage> stages() const override {
    const HardSphereEffects& on = run_->effects();
    std::vector<SceneStage> stages;
    stages.push_back({"flight", std::to_string(on.dimension) +
                                    (on.dimension == 1 ? " coordinate" : " coordinates") +
                                    (on.gravity ? ", parabolas" : ", straight lines")});
    if (on.gravity) stages.push_back({"gravity", "exact, with rest on walls"});
    if (on.grid) stages.push_back({"broad phase", "cells"});
    stages.push_back({"event queue", "the earliest hit first"});
    stages.push_back({"impulse", on.sizes ? "by mass and radius" : "of equal balls"});
    if (on.restitution) stages.push_back({"restitution", "of each pair of materials"});
    return stages;
  }

  /// @cond
  using SceneRun::advance;
  /// @endcond
  SceneRunEnd advance(double until, std::uint64_t budget, SceneObserver* observer) override {
    Teller teller(*this, observer);
    switch (run_->advance(until, budget, observer == nullptr ? nullptr : &teller)) {
      case HardSphereEnd::reached:
        return SceneRunEnd::reached;
      case HardSphereEnd::out_of_events:
        return SceneRunEnd::out_of_budget;
      case HardSphereEnd::stopped:
        return SceneRunEnd::stopped;
      default:
        return SceneRunEnd::endless_hits;
    }
  }

  double now() const override { return run_->now(); }
  Vector3<double> position(std::size_t body) const override {
    return is_ball_here(body) ? run_->position(ball_of_[body]) : scene_.bodies[body].position;
  }
  Rotor<double> orientation(std::size_t body) const override {
    return scene_.bodies[body].orientation;
  }
  Vector3<double> velocity(std::size_t body) const override {
    return is_ball_here(body) ? run_->velocity(ball_of_[body]) : Vector3<double>::Zero();
  }
  Vector3<double> spin(std::size_t body) const override { return scene_.bodies[body].spin; }
  double energy() const override { return detail::energy_of_run(scene_, *this); }

  SceneRunCounts counts() const override {
    const HardSphereCounts of = run_->counts();
    SceneRunCounts counts;
    counts.hits = of.hits;
    counts.crossings = of.crossings;
    counts.rests = of.rests;
    counts.largest_overlap = of.largest_overlap;
    counts.rest_error = of.rest_error;
    if (of.endless_partner >= 0) {
      counts.endless_first = balls_.ball_body[of.endless_ball];
      counts.endless_second = body_of(static_cast<std::size_t>(of.endless_partner));
    }
    return counts;
  }
  std::size_t bytes() const override { return run_->bytes(); }
  std::size_t bytes_per_body() const override { return run_->bytes_per_state(); }

  SceneCheckpoint checkpoint() const override {
    const HardSphereCheckpoint from = run_->checkpoint();
    SceneCheckpoint to;
    to.kind = "event-driven";
    to.now = from.now;
    to.counts = counts();
    to.integers = {static_cast<std::int64_t>(from.at_once),
                   static_cast<std::int64_t>(from.counts.stale)};
    for (const HardSphereCheckpoint::Ball& ball : from.balls) {
      for (int k = 0; k < 3; ++k) to.numbers.push_back(ball.position(k));
      for (int k = 0; k < 3; ++k) to.numbers.push_back(ball.velocity(k));
      to.numbers.push_back(ball.time);
      to.integers.insert(to.integers.end(), {ball.last, ball.lies_on, ball.short_flights});
    }
    return to;
  }
  void restore(const SceneCheckpoint& from) override {
    const std::size_t balls = balls_.ball_body.size();
    if (from.kind != "event-driven" || from.numbers.size() != 7 * balls ||
        from.integers.size() != 3 * balls + 2) {
      throw_invalid_argument("from", "a checkpoint of kind " + from.kind,
                             "must be one of this run from event to event");
    }
    HardSphereCheckpoint to;
    to.now = from.now;
    to.at_once = static_cast<std::uint64_t>(from.integers[0]);
    to.counts.stale = static_cast<std::uint64_t>(from.integers[1]);
    to.counts.hits = from.counts.hits;
    to.counts.crossings = from.counts.crossings;
    to.counts.rests = from.counts.rests;
    to.counts.largest_overlap = from.counts.largest_overlap;
    to.counts.rest_error = from.counts.rest_error;
    for (std::size_t i = 0; i < balls; ++i) {
      HardSphereCheckpoint::Ball ball;
      for (int k = 0; k < 3; ++k) {
        const auto at = 7 * i + static_cast<std::size_t>(k);
        ball.position(k) = from.numbers[at];
        ball.velocity(k) = from.numbers[at + 3];
      }
      ball.time = from.numbers[7 * i + 6];
      ball.last = static_cast<std::int32_t>(from.integers[3 * i + 2]);
      ball.lies_on = static_cast<std::int32_t>(from.integers[3 * i + 3]);
      ball.short_flights = static_cast<std::int32_t>(from.integers[3 * i + 4]);
      to.balls.push_back(ball);
    }
    run_->restore(to);
  }

  /// Of which effects of hard balls it is composed.
  const HardSphereEffects& effects() const { return run_->effects(); }

 private:
  static constexpr std::size_t no_ball = std::numeric_limits<std::size_t>::max();

  /// Tells of balls' hits as of bodies'.
  class Teller final : public HardSphereObserver {
   public:
    Teller(const HardSphereSceneRun& of, SceneObserver* to) : of_(of), to_(to) {}
    bool on_hit(const HardSphereHit& hit) override {
      return to_->on_hit({hit.time, of_.balls_.ball_body[hit.ball], of_.body_of(hit.partner),
                          of_.touching_point(hit), hit.impulse});
    }

   private:
    const HardSphereSceneRun& of_;
    SceneObserver* to_;
  };

  bool is_ball_here(std::size_t body) const { return ball_of_[body] != no_ball; }
  std::size_t body_of(std::size_t partner) const {
    const std::size_t count = balls_.ball_body.size();
    return partner < count ? balls_.ball_body[partner] : balls_.wall_body[partner - count];
  }
  Vector3<double> touching_point(const HardSphereHit& hit) const {
    const std::size_t count = balls_.ball_body.size();
    const Vector3<double> centre = run_->position(hit.ball);
    const double radius = balls_.setup.balls[hit.ball].radius;
    if (hit.partner >= count)
      return centre - balls_.setup.walls[hit.partner - count].normal * radius;
    const double other = balls_.setup.balls[hit.partner].radius;
    return centre + (run_->position(hit.partner) - centre) * (radius / (radius + other));
  }

  Scene scene_;
  HardSphereScene balls_;
  std::unique_ptr<HardSphereRun> run_;
  std::vector<std::size_t> ball_of_;  // by body
};
// [/hard-sphere-scene-run]

}  // namespace contact
