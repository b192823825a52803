// A plan leaves out only what it may: the run that it decides on, compared with runs with more
// effects. From event to event, and up to the horizon.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/events/hard_sphere_scene.hpp>
#include <contact/plan/plan.hpp>
#include <contact/scene/scene_runs.hpp>

#include "plan_scenes.hpp"
#include "soundness.hpp"
#include "support/generators.hpp"

using contact::Effect;
using contact::Plan;
using contact::PlanOptions;
using contact::Scene;
using generators::Random;
using generators::tried;
using plan_scenes::Point;
using soundness::all_physics;
using soundness::comparable_time;
using soundness::farthest_apart;
using soundness::random_balls;
using soundness::scenes_of_the_book;

namespace {

/// The largest distance of a run from event to event from one step by step that has all of physics,
/// up to a time.
double from_steps_with_everything(const Scene& scene, double end, double step) {
  PlanOptions options;
  options.step = step;
  options.overrides.with.assign(std::begin(all_physics), std::end(all_physics));
  const auto events = contact::scenes::make_run(scene, contact::plan_scene(scene));
  const auto steps = contact::scenes::make_run(scene, contact::plan_scene(scene, options));
  REQUIRE(events->event_driven());
  REQUIRE_FALSE(steps->event_driven());
  return farthest_apart(scene, *events, *steps, end);
}

}  // namespace

TEST_CASE("from event to event, the book's scenes agree with steps with all effects") {
  int runs = 0;
  for (const Scene& scene : scenes_of_the_book()) {
    const Plan plan = contact::plan_scene(scene);
    if (plan.step > 0 || contact::hard_sphere_refusal(scene)) continue;
    if (!scene.tolerance.position || scene.bodies.size() > 100) continue;
    const double end = comparable_time(scene, plan);
    CAPTURE(scene.name, end);
    const double apart = from_steps_with_everything(scene, end, std::min(end / 64, 1.0 / 240));
    CAPTURE(apart);
    CHECK(apart <= *scene.tolerance.position);
    ++runs;
  }
  CHECK(runs >= 6);
}

TEST_CASE("from event to event, random balls agree with steps with all effects") {
  Random random(21);
  double farthest = 0;
  for (int trial = 0; trial < tried(400); ++trial) {
    const Scene scene = random_balls(random);
    const Plan plan = contact::plan_scene(scene);
    if (plan.step > 0) continue;
    CAPTURE(trial);
    const double end = comparable_time(scene, plan);
    const double apart = from_steps_with_everything(scene, end, std::min(end / 16, 1.0 / 240));
    farthest = std::max(farthest, apart);
    REQUIRE(apart <= *scene.tolerance.position);
  }
  // They are two programs: the same bits everywhere would mean that one of them was run twice.
  CHECK(farthest > 0);
}

namespace {

/// Moving bodies start an ulp faster or slower, in turns: in the same plane, or on the same line.
Scene an_ulp_away(Scene scene) {
  double sign = 1;
  for (auto& body : scene.bodies) {
    body.velocity *= 1 + sign * 0x1p-52;
    sign = -sign;
  }
  return scene;
}

/// Balls of many masses that fall on a line, or one between two slopes.
Scene that_falls(Random& random) {
  Scene scene = plan_scenes::empty(1, 0, 40, std::pow(10.0, -random.integer(3, 9)));
  scene.gravity = Point(0, 0, -10);
  if (random.chance(0.5)) {
    plan_scenes::wall(scene, Point::UnitZ(), 0);
    const int count = random.integer(2, 3);
    for (int i = 0; i < count; ++i) {
      const double mass = std::pow(10.0, random.uniform(-1, 1));
      const double speed = random.uniform(-2, 2);
      const double height = 0.5 + i * random.uniform(0.6, 2);
      plan_scenes::ball(scene, 0.25, mass, {0, 0, height}, {0, 0, speed});
    }
    return scene;
  }
  for (const double side : {-1.0, 1.0}) {
    const double slope = random.uniform(0.2, 1.4);
    plan_scenes::wall(scene, Point(side * std::sin(slope), 0, std::cos(slope)).normalized(), 0);
  }
  const double speed = random.uniform(-2, 2);
  const double height = random.uniform(2, 4);
  plan_scenes::ball(scene, 0.125, 1, {0, 0, height}, {speed, 0, 0});
  return scene;
}

/// Balls in a room, in a crowd in the middle of it, or in a plane; one ball among posts, in a cage
/// of posts or of boxes within a much larger room, perhaps with a heavy body beside it.
Scene that_spreads(Random& random) {
  Scene scene = plan_scenes::empty(1, 0, 20, std::pow(10.0, -random.integer(3, 9)));
  scene.gravity = Point::Zero();
  const int kind = random.integer(0, 6);
  if (kind == 6) return that_falls(random);
  const double decades = random.chance(0.5) ? random.uniform(0, 5) : 0;
  const double room = kind == 0 || kind == 2 ? random.uniform(4.6, 12) : 40;
  plan_scenes::walls(scene, Point(room, room, room));
  const Point middle = Point::Constant(room / 2);
  const auto velocity = [&] {
    Point v = Point::Zero();
    for (int k = 0; k < (kind == 2 ? 2 : 3); ++k) v(k) = random.uniform(-1, 1);
    return v;
  };
  if (kind <= 2) {
    // Discs lie in the plane; no body starts within another.
    const double spacing = kind == 1 ? random.uniform(0.9, 1.2) : (room - 0.8) / 3;
    const int count = random.integer(2, 16);
    for (int i = 0; i < count; ++i) {
      Point x = middle + spacing * (Point(i % 3, i / 3 % 3, i / 9) - Point::Ones());
      if (kind == 2)
        x = Point(0.5 + i % 4 * (room - 1) / 4, 0.5 + i / 4 * (room - 1) / 4, room / 2);
      const Point v = velocity();
      plan_scenes::ball(scene, 0.4, std::pow(10.0, decades * random.uniform()), x, v);
    }
    return scene;
  }
  if (decades > 1) plan_scenes::ball(scene, 0.25, std::pow(10.0, decades), {2, 2, 2});
  const Point v = velocity();
  plan_scenes::ball(scene, 0.25, 1, middle, v);
  const double away = random.uniform(0.6, 1.5);
  for (int i = 0; i < 27; ++i) {
    const Point at(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    if (i == 13 || (kind != 3 && at.squaredNorm() > 1)) continue;
    const Point x = middle + (away + 0.3) * at;
    if (kind < 5)
      plan_scenes::ball(scene, kind == 3 ? 0.3 : 0.75 * away, 0, x);
    else
      plan_scenes::box(scene, {0.2, 0.25, 0.3}, 0, x);
  }
  return scene;
}

}  // namespace

TEST_CASE("before the horizon a run that starts an ulp away is within the tolerance") {
  Random random(77);
  int asked = 0;
  int diverged_later = 0;
  for (int i = 0; i < tried(400); ++i) {
    const Scene scene = that_spreads(random);
    const Plan plan = contact::plan_scene(scene);
    const auto horizon = contact::decision_on(plan, Effect::horizon).value;
    if (!horizon) continue;
    const auto run = contact::scenes::make_run(scene, plan);
    const auto twin = contact::scenes::make_run(an_ulp_away(scene), plan);
    const auto apart_at = [&](double time) {
      run->advance(time);
      twin->advance(time);
      double apart = 0;
      for (std::size_t b = 0; b < scene.bodies.size(); ++b)
        apart = std::max(apart, Point(run->position(b) - twin->position(b)).norm());
      return apart;
    };
    CAPTURE(i, *horizon);
    for (const int eighth : {1, 2, 3, 4, 5, 6, 7, 8})
      CHECK(apart_at(std::min(*horizon, 20.0) * eighth / 8) <= *scene.tolerance.position);
    ++asked;
    if (plan.step > 0 || *horizon > 5) continue;
    if (apart_at(20 * *horizon) > *scene.tolerance.position) ++diverged_later;
  }
  CHECK(asked > tried(300));
  CHECK(diverged_later > tried(8));  // the horizon is no safer than it has to be
}
