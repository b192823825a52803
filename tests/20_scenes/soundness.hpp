/// @file
/// Random scenes, and the distance between two runs of one.
#pragma once

#include <algorithm>
#include <contact/events/hard_sphere_scene.hpp>
#include <contact/scene/scene_file.hpp>
#include <limits>
#include <vector>

#include "plan_scenes.hpp"
#include "support/generators.hpp"

namespace soundness {

using contact::Effect;
using contact::Plan;
using contact::Scene;
using contact::SceneRun;
using generators::Random;
using generators::tried;
using plan_scenes::Point;

// A run in these tests is over when so many moves of bodies are.
inline constexpr double max_moves = tried(4000);

inline std::vector<Scene> scenes_of_the_book() {
  std::vector<Scene> scenes;
  for (const auto& file :
       contact::scenes::scenes_in(CONTACT_SOURCE_DIR "/chapters/20_scenes/scenes"))
    scenes.push_back(contact::scenes::read_scene(file));
  return scenes;
}

/// Until when positions can be compared: the end, the horizon, or what time allows. For rotating
/// bodies with vertices no horizon is known, and time costs more: an eighth of it.
inline double comparable_time(const Scene& scene, const Plan& plan) {
  double end = scene.duration;
  const auto& horizon = contact::decision_on(plan, Effect::horizon);
  if (horizon.value) end = std::min(end, *horizon.value);
  const double moves = horizon.on && !horizon.value ? max_moves / 8 : max_moves;
  const auto movers = static_cast<double>(std::count_if(
      scene.bodies.begin(), scene.bodies.end(), [](const auto& body) { return body.moves; }));
  const double step = plan.step > 0 ? plan.step : 1.0 / 60;
  return std::min(end, moves / movers * step);
}

inline bool same_lie(const contact::Quaternion<double>& one,
                     const contact::Quaternion<double>& other) {
  return one.w == other.w && one.v == other.v;
}

/// The largest distance between the same bodies of two runs, at sixteen times; 0 only if all bits
/// of positions, velocities and angular velocities agree, and of orientations of bodies other than
/// balls.
inline double farthest_apart(const Scene& scene, SceneRun& one, SceneRun& other, double end) {
  double farthest = 0;
  for (int k = 1; k <= 16; ++k) {
    one.advance(end * k / 16);
    other.advance(end * k / 16);
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const double apart = (one.position(i) - other.position(i)).norm();
      farthest = std::max(farthest, apart);
      const bool ball = std::holds_alternative<contact::BallShape>(scene.bodies[i].shape);
      if (one.velocity(i) != other.velocity(i) ||
          one.angular_velocity(i) != other.angular_velocity(i) ||
          (!ball && !same_lie(one.orientation(i), other.orientation(i))))
        farthest = std::max(farthest, std::numeric_limits<double>::denorm_min());
    }
  }
  return farthest;
}

/// Effects that a run step by step can have beside those of its plan, none of which reduces its
/// accuracy.
inline constexpr Effect all_physics[] = {Effect::gravity,         Effect::rotation,
                                         Effect::gyroscopic_term, Effect::friction,
                                         Effect::restitution,     Effect::continuous_detection,
                                         Effect::broad_phase,     Effect::several_contacts,
                                         Effect::resting,         Effect::penalty_contact};

/// Balls that do not touch yet between walls: on a line, in a plane or in space, equal or not, with
/// gravity or without, elastic or not.
inline Scene random_balls(Random& random) {
  const int dimension = random.integer(1, 3);
  const bool alike = random.integer(0, 1) == 1;
  const double e = random.integer(0, 2) > 0 ? 1 : random.uniform(0.5, 1);
  Scene scene = plan_scenes::empty(e, 0, 2, 1e-6);
  scene.gravity = Point::Zero();
  if (random.integer(0, 1) == 1)
    scene.gravity(random.integer(0, dimension - 1)) = -random.uniform(1, 10);
  plan_scenes::walls(scene, Point(8, 8, 8));
  const int count = random.integer(1, 8);
  for (int i = 0; i < count; ++i) {
    Point x = Point::Constant(4);
    Point v = Point::Zero();
    const int places[3] = {dimension == 1 ? i : i % 2, i / 2 % (dimension == 2 ? 4 : 2), i / 4};
    for (int k = 0; k < dimension; ++k) {
      x(k) = dimension == 1 ? 0.5 + places[k] : 1 + 1.7 * places[k];
      v(k) = random.uniform(-3, 3);
    }
    const double radius = alike ? 0.25 : random.uniform(0.1, 0.49);
    const double mass = alike ? 1 : random.uniform(0.5, 4);
    plan_scenes::ball(scene, radius, mass, x, v);
  }
  return scene;
}

}  // namespace soundness
