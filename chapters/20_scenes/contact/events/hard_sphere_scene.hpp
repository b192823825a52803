/// @file
/// From a scene to a setup of hard, smooth balls, or the reason why it is not one; and the
/// event-driven run, in terms of the scene's bodies.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <contact/events/hard_sphere_run.hpp>
#include <contact/quaternion.hpp>
#include <contact/scene/scene.hpp>
#include <contact/scene/scene_run.hpp>
#include <contact/vector.hpp>

namespace contact {

/// Hard, smooth balls, and which body of the scene each is.
struct HardSphereScene {
  HardSphereSetup setup;               ///< the balls and walls
  std::vector<std::size_t> ball_body;  ///< index into Scene::bodies of each ball
  std::vector<std::size_t> wall_body;  ///< the same of each wall
};

/// Why a scene is not one of hard, smooth balls, or empty if it is: its bodies are balls and
/// half-spaces, at least one ball moves, no half-space moves, and no contact has friction or is
/// compliant. Without friction no torque acts on a ball, so angular velocities do not matter.
/// @param scene checked
std::optional<std::string> hard_sphere_refusal(const Scene& scene);

/// The setup of a scene for which hard_sphere_refusal() is empty.
/// @throws std::invalid_argument if it is not
HardSphereScene hard_sphere_setup(const Scene& scene);

/// Makes the run of a setup: make_hard_spheres() of contact/hard_sphere_make.hpp, or another that
/// has been compiled already.
using ComposeHardSpheres = std::unique_ptr<HardSphereRun> (*)(const HardSphereSetup&);

/// Hard, smooth balls of a scene. Angular velocities and orientations stay as at the start: no
/// torque acts on a smooth ball.
class HardSphereSceneRun final : public SceneRun {
 public:
  /// @param scene for which hard_sphere_refusal() is empty
  /// @param compose makes the run
  /// @param cutoff s; shorter bounces are left out; 0: those that time hardly resolves
  HardSphereSceneRun(const Scene& scene, ComposeHardSpheres compose, double cutoff = 0);

  bool event_driven() const override { return true; }
  double step() const override { return 0; }
  std::vector<SceneStage> stages() const override;

  /// @cond
  using SceneRun::advance;
  /// @endcond
  SceneRunEnd advance(double until, std::uint64_t budget, SceneObserver* observer) override;

  double now() const override { return run_->now(); }
  Vector3<double> position(std::size_t body) const override {
    return is_ball_here(body) ? run_->position(ball_of_[body]) : scene_.bodies[body].position;
  }
  Quaternion<double> orientation(std::size_t body) const override {
    return scene_.bodies[body].orientation;
  }
  Vector3<double> velocity(std::size_t body) const override {
    return is_ball_here(body) ? run_->velocity(ball_of_[body]) : Vector3<double>::Zero();
  }
  Vector3<double> angular_velocity(std::size_t body) const override {
    return scene_.bodies[body].angular_velocity;
  }
  double energy() const override { return detail::energy_of_run(scene_, *this); }

  SceneRunCounts counts() const override;
  std::size_t bytes() const override { return run_->bytes(); }
  std::size_t bytes_per_body() const override { return run_->bytes_per_state(); }

  SceneCheckpoint checkpoint() const override;
  void restore(const SceneCheckpoint& from) override;

  /// The effects of hard balls of which it is composed.
  const HardSphereEffects& effects() const { return run_->effects(); }

 private:
  static constexpr std::size_t no_ball = std::numeric_limits<std::size_t>::max();

  /// Reports balls' hits as bodies' hits.
  class HitForwarder final : public HardSphereObserver {
   public:
    HitForwarder(const HardSphereSceneRun& of, SceneObserver* to) : of_(of), to_(to) {}
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
  Vector3<double> touching_point(const HardSphereHit& hit) const;

  Scene scene_;
  HardSphereScene balls_;
  std::unique_ptr<HardSphereRun> run_;
  std::vector<std::size_t> ball_of_;  // by body
};

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/hard_sphere_scene.cpp"
#endif
