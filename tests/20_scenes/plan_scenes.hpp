/// @file
/// Scenes for the planner's tests, made by hand, and accessors of their plans.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <contact/plan/plan.hpp>
#include <contact/scene/scene.hpp>
#include <contact/scene/scene_check.hpp>
#include <contact/scene/scene_run.hpp>
#include <contact/scene/scene_runs.hpp>
#include <contact/scene/scene_solids.hpp>

namespace plan_scenes {

using contact::Effect;
using contact::Scene;
using contact::SceneBody;
using Point = contact::Vector3<double>;

/// A scene with one material; nothing in it yet.
inline Scene empty(double restitution, double friction, double duration, double tolerance) {
  Scene scene;
  scene.name = "made_by_hand";
  scene.materials.push_back({"stuff", restitution, friction, {}, 0});
  scene.duration = duration;
  if (tolerance > 0)
    scene.tolerance.position = tolerance;
  else
    scene.tolerance.event_order = true;
  return scene;
}

inline SceneBody& add(Scene& scene, contact::SceneShape shape, double mass, const Point& position,
                      const Point& velocity = Point::Zero()) {
  SceneBody body;
  body.name = "body_" + std::to_string(scene.bodies.size());
  body.shape = std::move(shape);
  body.moves = mass > 0;
  body.mass = mass;
  if (mass > 0) body.inertia = contact::solid_inertia(body.shape, mass);
  body.position = position;
  body.velocity = velocity;
  scene.bodies.push_back(std::move(body));
  return scene.bodies.back();
}

inline SceneBody& ball(Scene& scene, double radius, double mass, const Point& position,
                       const Point& velocity = Point::Zero()) {
  return add(scene, contact::BallShape{radius}, mass, position, velocity);
}

inline SceneBody& box(Scene& scene, const Point& half_lengths, double mass, const Point& position,
                      const Point& velocity = Point::Zero()) {
  return add(scene, contact::BoxShape{half_lengths}, mass, position, velocity);
}

inline SceneBody& wall(Scene& scene, const Point& normal, double offset) {
  return add(scene, contact::HalfSpaceShape{normal, offset}, 0, Point::Zero());
}

/// Balls in a box of walls at 0 and `size`.
inline void walls(Scene& scene, const Point& size) {
  for (int k = 0; k < 3; ++k) {
    wall(scene, Point::Unit(k), 0);
    wall(scene, -Point::Unit(k), -size(k));
  }
}

inline bool is_on(const Scene& scene, Effect effect) {
  return contact::decision_on(contact::plan_scene(scene), effect).on;
}

inline contact::Decision decision(const Scene& scene, Effect effect,
                                  const contact::PlanOptions& options = {}) {
  return contact::decision_on(contact::plan_scene(scene, options), effect);
}

/// A run of the scene as its plan has it.
inline std::unique_ptr<contact::SceneRun> run_of(const Scene& scene,
                                                 const contact::PlanOptions& options = {}) {
  return contact::scenes::make_run(scene, contact::plan_scene(scene, options));
}

}  // namespace plan_scenes
