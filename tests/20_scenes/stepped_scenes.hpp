/// @file
/// Scenes for the tests of runs step by step, and queries of such a run.
#pragma once

#include <algorithm>
#include <bit>
#include <contact/scene/make_scene_run.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "plan_at_edge.hpp"
#include "plan_scenes.hpp"
#include "support/generators.hpp"

namespace stepped_scenes {

using contact::Effect;
using contact::PlanOptions;
using contact::Scene;
using contact::SceneRun;
using generators::Random;
using plan_scenes::Point;

inline PlanOptions with(std::vector<Effect> effects) {
  PlanOptions options;
  options.overrides.with = std::move(effects);
  return options;
}

inline PlanOptions without(std::vector<Effect> effects) {
  PlanOptions options;
  options.overrides.without = std::move(effects);
  return options;
}

inline bool has_stage(const SceneRun& run, const std::string& name) {
  const auto stages = run.stages();
  return std::any_of(stages.begin(), stages.end(),
                     [&](const contact::SceneStage& stage) { return stage.name == name; });
}

inline Scene with_gravity(double restitution, double friction, double duration, double tolerance) {
  Scene scene = plan_scenes::empty(restitution, friction, duration, tolerance);
  scene.gravity = Point(0, 0, -10);
  return scene;
}

/// The state of all bodies of a run, as bits.
inline std::vector<std::uint64_t> bits_of(const Scene& scene, const SceneRun& run) {
  std::vector<std::uint64_t> bits;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    for (const Point& v :
         {run.position(i), run.velocity(i), run.angular_velocity(i), run.orientation(i).v})
      for (int k = 0; k < 3; ++k) bits.push_back(std::bit_cast<std::uint64_t>(v(k)));
    bits.push_back(std::bit_cast<std::uint64_t>(run.orientation(i).w));
  }
  return bits;
}

inline Point total_momentum(const Scene& scene, const SceneRun& run) {
  Point sum = Point::Zero();
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    if (scene.bodies[i].moves) sum += run.velocity(i) * scene.bodies[i].mass;
  return sum;
}

inline Point any_direction(Random& random) {
  for (;;) {
    const double x = random.uniform(-1, 1);
    const double y = random.uniform(-1, 1);
    const double z = random.uniform(-1, 1);
    const Point v(x, y, z);
    if (v.norm() > 0.1 && v.norm() < 1) return v.normalized();
  }
}

inline void any_body(Random& random, Scene& scene, const Point& x) {
  const int kind = random.integer(0, 2);
  const double a = random.uniform(0.2, 0.4);
  const double b = random.uniform(0.2, 0.4);
  const double c = random.uniform(0.2, 0.4);
  const double mass = random.uniform(1, 3);
  contact::SceneShape shape = contact::BallShape{a};
  if (kind == 1) shape = contact::BoxShape{Point(a, b, c) / 2};
  if (kind == 2) shape = contact::CapsuleShape{a / 2, b / 2};
  contact::SceneBody& body = plan_scenes::add(scene, shape, mass, x);
  const Point axis = any_direction(random);
  const double angle = random.uniform(0, 3);
  body.orientation = contact::exponential<double>(axis * angle);
}

/// Four bodies of any kind that fly to the centre from all sides, rotating.
inline Scene crash(Random& random, double restitution, double friction) {
  Scene scene = plan_scenes::empty(restitution, friction, 1, 1e-6);
  for (const Point& corner :
       {Point(1, 1, 1), Point(-1, -1, 1), Point(-1, 1, -1), Point(1, -1, -1)}) {
    any_body(random, scene, corner);
    contact::SceneBody& body = scene.bodies.back();
    const Point aside = any_direction(random);
    body.velocity = -2 * corner + 0.3 * aside;
    body.angular_velocity = 3 * any_direction(random);
  }
  return scene;
}

/// Hits of a run, as the observer sees them.
struct Hits final : contact::SceneObserver {
  std::vector<contact::SceneHit> seen;
  bool on_hit(const contact::SceneHit& hit) override {
    seen.push_back(hit);
    return true;
  }
};

}  // namespace stepped_scenes
