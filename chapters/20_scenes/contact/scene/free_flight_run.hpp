/// @file
/// Bodies that meet nothing and whose angular velocities are constant: a formula for any time, and
/// no steps.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <contact/inertia.hpp>
#include <contact/invalid_argument.hpp>
#include <contact/plan/plan_types.hpp>
#include <contact/quaternion.hpp>
#include <contact/rotation.hpp>
#include <contact/scene/scene.hpp>
#include <contact/scene/scene_run.hpp>
#include <contact/vector.hpp>

namespace contact {

// [flies-freely]
/// Whether nothing of a planned scene meets anything and every angular velocity is constant. Then
/// each body is at x₀ + t (v₀ + t g/2), rotated by ω t.
inline bool flies_freely(const Plan& plan) {
  const bool steady =
      !decision_on(plan, Effect::rotation).on || !decision_on(plan, Effect::gyroscopic_term).on;
  return plan.pairs == 0 && decision_on(plan, Effect::event_driven).on && steady;
}
// [/flies-freely]

// [free-flight-run]
/// A run of bodies that fly freely. It stores the initial state of each, in the type and the
/// coordinates that the plan asks for; positions are computed on request.
/// @tparam S float or double
/// @tparam Dimension number of coordinates that change
template <std::floating_point S, int Dimension>
class FreeFlightRun final : public SceneRun {
 public:
  /// @param scene with a plan for which flies_freely() is true
  /// @param axes which coordinates change; `Dimension` of them count
  /// @param turning whether orientations are kept
  FreeFlightRun(const Scene& scene, const std::array<int, 3>& axes, bool turning)
      : scene_(scene), axes_(axes), pull_(kept(scene.gravity)) {
    flight_of_.assign(scene.bodies.size(), none);
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const SceneBody& body = scene.bodies[i];
      if (!body.moves) continue;
      flight_of_[i] = flights_.size();
      flights_.push_back({kept(body.position), kept(body.velocity)});
      if (!turning) continue;
      const Vector3<S> angular_velocity = body.angular_velocity.cast<S>();
      rotations_.push_back(
          {{S(body.orientation.w), body.orientation.v.cast<S>()}, angular_velocity});
    }
  }

  /// @cond
  using SceneRun::advance;
  /// @endcond
  bool event_driven() const override { return true; }
  double step() const override { return 0; }
  std::vector<SceneStage> stages() const override {
    const bool falls = pull_ != Point::Zero();
    const std::string type = std::same_as<S, float> ? ", in float" : "";
    std::vector<SceneStage> stages{
        {"flight", std::to_string(Dimension) + (Dimension == 1 ? " coordinate" : " coordinates") +
                       (falls ? ", parabolas" : ", straight lines") + type}};
    if (falls) stages.push_back({"gravity", "exact"});
    if (!rotations_.empty()) stages.push_back({"turning", "with constant angular velocities"});
    return stages;
  }

  SceneRunEnd advance(double until, std::uint64_t /*budget*/,
                      SceneObserver* /*observer*/) override {
    now_ = std::max(now_, until);
    return SceneRunEnd::reached;
  }

  double now() const override { return now_; }
  Vector3<double> position(std::size_t body) const override {
    Vector3<double> x = scene_.bodies[body].position;
    if (flight_of_[body] == none) return x;
    const Flight& flight = flights_[flight_of_[body]];
    const S t = static_cast<S>(now_);
    spread(flight.position + (flight.velocity * t + pull_ * (t * t / 2)), x);
    return x;
  }
  Vector3<double> velocity(std::size_t body) const override {
    Vector3<double> v = Vector3<double>::Zero();
    if (flight_of_[body] == none) return v;
    spread(flights_[flight_of_[body]].velocity + pull_ * static_cast<S>(now_), v);
    return v;
  }
  Quaternion<double> orientation(std::size_t body) const override {
    if (flight_of_[body] == none || rotations_.empty()) return scene_.bodies[body].orientation;
    const Rotation& rotation = rotations_[flight_of_[body]];
    const Quaternion<S> q = normalised(
        exponential_step(rotation.orientation, rotation.angular_velocity, static_cast<S>(now_)));
    return {static_cast<double>(q.w), q.v.template cast<double>()};
  }
  Vector3<double> angular_velocity(std::size_t body) const override {
    if (flight_of_[body] == none || rotations_.empty()) return scene_.bodies[body].angular_velocity;
    return rotations_[flight_of_[body]].angular_velocity.template cast<double>();
  }
  double energy() const override { return detail::energy_of_run(scene_, *this); }
  SceneRunCounts counts() const override { return {}; }
  std::size_t bytes() const override {
    return flights_.capacity() * sizeof(Flight) + rotations_.capacity() * sizeof(Rotation) +
           flight_of_.capacity() * sizeof(std::size_t);
  }
  std::size_t bytes_per_body() const override {
    return sizeof(Flight) + (rotations_.empty() ? 0 : sizeof(Rotation));
  }

  /// The time is the whole state.
  SceneCheckpoint checkpoint() const override {
    SceneCheckpoint to;
    to.kind = "free flight";
    to.now = now_;
    return to;
  }
  void restore(const SceneCheckpoint& from) override {
    if (from.kind != "free flight") {
      throw_invalid_argument("from", "a checkpoint of kind " + from.kind,
                             "must be one of this run of free flights");
    }
    now_ = from.now;
  }

 private:
  using Point = Eigen::Matrix<S, Dimension, 1>;
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  struct Flight {
    Point position;  // initial, m
    Point velocity;  // m/s
  };
  struct Rotation {
    Quaternion<S> orientation;    // initial
    Vector3<S> angular_velocity;  // rad/s
  };

  Point kept(const Vector3<double>& v) const {
    Point p;
    for (int k = 0; k < Dimension; ++k)
      p(k) = static_cast<S>(v(axes_[static_cast<std::size_t>(k)]));
    return p;
  }
  void spread(const Point& from, Vector3<double>& to) const {
    for (int k = 0; k < Dimension; ++k)
      to(axes_[static_cast<std::size_t>(k)]) = static_cast<double>(from(k));
  }

  Scene scene_;
  std::array<int, 3> axes_;
  Point pull_;  // m/s²
  double now_ = 0;
  std::vector<Flight> flights_;
  std::vector<Rotation> rotations_;     // empty if nothing rotates
  std::vector<std::size_t> flight_of_;  // by body
};
// [/free-flight-run]

/// The run of bodies that fly freely, with the numbers that its plan asks for: only the coordinates
/// that change unless the plan has more on, float where that suffices, orientations where bodies
/// rotate.
/// @param plan for which flies_freely() is true
std::unique_ptr<SceneRun> make_free_flight_run(const Scene& scene, const Plan& plan);

}  // namespace contact

#ifndef CONTACT_SCENES_COMPILED
#include "../../src/free_flight_run.cpp"
#endif
