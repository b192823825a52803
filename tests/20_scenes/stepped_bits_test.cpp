// Scenes step by step: the same scene gives the same bits, and an effect that is off is neither
// computed nor stored.
#include <catch2/catch_test_macros.hpp>
#include <cstdint>

#include "plan_at_edge.hpp"
#include "plan_scenes.hpp"
#include "stepped_scenes.hpp"
#include "support/generators.hpp"

using contact::Effect;
using contact::PlanOptions;
using contact::Scene;
using generators::Random;
using plan_scenes::Point;
using plan_scenes::run_of;
using plan_scenes::stepped;
using stepped_scenes::any_direction;
using stepped_scenes::bits_of;
using stepped_scenes::crash;
using stepped_scenes::has_stage;
using stepped_scenes::with;
using stepped_scenes::with_gravity;
using stepped_scenes::without;

TEST_CASE("the same scene gives the same bits, wherever the run is stopped on the way") {
  Random random(8);
  for (int i = 0; i < generators::tried(24); ++i) {
    Scene scene = crash(random, 0.5, 0.3);
    scene.gravity = Point(0, 0, -10);
    plan_scenes::wall(scene, Point::UnitZ(), -2);
    auto one = run_of(scene, stepped(1.0 / 60));
    auto other = run_of(scene, stepped(1.0 / 60));
    one->advance(1);
    for (int k = 0; k < 7; ++k) {
      other->advance(other->now() + random.uniform(0, 0.1));
      if (k != 3) continue;
      // And from here on another run that goes on from a checkpoint.
      const auto kept = other->checkpoint();
      const auto there = bits_of(scene, *other);
      other = run_of(scene, stepped(1.0 / 60));
      other->restore(kept);
      CHECK(other->now() == kept.now);
      CHECK(bits_of(scene, *other) == there);
    }
    other->advance(1);
    CHECK(bits_of(scene, *one) == bits_of(scene, *other));
    CHECK(one->counts().hits == other->counts().hits);
    CHECK(one->counts().iterations == other->counts().iterations);
  }
}

TEST_CASE("a checkpoint of something else is rejected") {
  Scene scene = plan_scenes::empty(1, 0, 1, 1e-6);
  plan_scenes::ball(scene, 0.5, 1, {0, 0, 0}, {1, 0, 0});
  plan_scenes::ball(scene, 0.5, 1, {5, 0, 0});
  auto run = run_of(scene, stepped(0.1));
  auto events = run_of(scene);
  REQUIRE(events->event_driven());
  CHECK_THROWS_AS(run->restore(events->checkpoint()), std::invalid_argument);
  CHECK_THROWS_AS(events->restore(run->checkpoint()), std::invalid_argument);
  auto kept = run->checkpoint();
  kept.numbers.pop_back();
  CHECK_THROWS_AS(run->restore(kept), std::invalid_argument);
}

TEST_CASE("state that no effect needs is not stored, and an effect that is off has no stage") {
  Scene smooth = with_gravity(0.5, 0, 1, 1e-6);
  plan_scenes::wall(smooth, Point::UnitZ(), 0);
  plan_scenes::ball(smooth, 0.5, 1, {0, 0, 2});
  plan_scenes::ball(smooth, 0.5, 1, {0.2, 0, 4});
  auto run = run_of(smooth, stepped(0.01));
  const std::size_t least = 4 * sizeof(double);  // in a plane
  const std::size_t turning = least + sizeof(double) + sizeof(contact::Quaternion<double>);
  const std::size_t resting = sizeof(double) + sizeof(std::int32_t);
  for (const char* name : {"rotation", "springs", "broad phase"})
    CHECK_FALSE(has_stage(*run, name));
  for (const char* name : {"gravity", "contacts", "time of impact"}) CHECK(has_stage(*run, name));
  PlanOptions bare = stepped(0.01);
  bare.overrides.without = {Effect::sleeping, Effect::gravity, Effect::resting,
                            Effect::continuous_detection, Effect::restitution};
  auto min_run = run_of(smooth, bare);
  CHECK(min_run->bytes_per_body() == least);
  for (const char* name :
       {"sleep", "waking", "gravity", "contact forces", "time of impact", "bounces"})
    CHECK_FALSE(has_stage(*min_run, name));
  bare.overrides.with = {Effect::rotation};
  CHECK(run_of(smooth, bare)->bytes_per_body() == turning);
  bare.overrides.without.erase(bare.overrides.without.begin());
  bare.overrides.with.push_back(Effect::sleeping);
  CHECK(run_of(smooth, bare)->bytes_per_body() == turning + resting);
}

TEST_CASE("positions and velocities have no coordinate that never changes") {
  Scene line = with_gravity(0.5, 0, 2, 1e-6);
  plan_scenes::wall(line, Point::UnitZ(), 0);
  plan_scenes::ball(line, 0.5, 1, {0.3, -0.7, 2});
  Scene plane = line;
  plan_scenes::ball(plane, 0.5, 1, {0.5, -0.7, 4});
  Scene space = plane;
  plan_scenes::ball(space, 0.5, 1, {0.4, -0.6, 6});
  const auto kept = [](const Scene& scene) {
    return run_of(scene, stepped(0.01))->bytes_per_body() -
           (has_stage(*run_of(scene, stepped(0.01)), "sleep")
                ? sizeof(double) + sizeof(std::int32_t)
                : 0);
  };
  CHECK(kept(line) == 2 * sizeof(double));
  CHECK(kept(plane) == 4 * sizeof(double));
  CHECK(kept(space) == 6 * sizeof(double));
  for (const Scene& scene : {line, plane}) {
    auto few = run_of(scene, stepped(0.01));
    PlanOptions options = stepped(0.01);
    options.overrides.with = {Effect::third_dimension, Effect::second_dimension};
    auto all = run_of(scene, options);
    CHECK(few->bytes_per_body() < all->bytes_per_body());
    few->advance(2);
    all->advance(2);
    CHECK(few->counts().hits > 0);
    CHECK(bits_of(scene, *few) == bits_of(scene, *all));
  }
}

TEST_CASE(
    "balls that roll in a plane have one number for angular velocity, and the bits of all "
    "effects") {
  int hits = 0;
  const int axes = generators::sanitized ? 1 : 3;
  for (int axis = 0; axis < axes; ++axis) {  // across the plane
    const Point across = Point::Unit(axis);
    const Point along = Point::Unit((axis + 1) % 3);
    const Point up = Point::Unit((axis + 2) % 3);
    Scene scene = with_gravity(0, 0.3, 2, 1e-6);
    scene.gravity = -10 * up;
    plan_scenes::wall(scene, up, 0);
    plan_scenes::wall(scene, -along, -3);
    for (int i = 0; i < 4; ++i) {
      const Point at = (1.25 * i) * along + (0.5 + 0.75 * (i % 2)) * up;
      plan_scenes::ball(scene, 0.5, 1, at - 4 * along);
      scene.bodies.back().velocity = (3 - i) * along + 0.5 * up;
      scene.bodies.back().angular_velocity = (2.0 * i - 3) * across;
    }
    PlanOptions options = stepped(0.01);
    auto few = run_of(scene, options);
    options.overrides.with = {Effect::third_dimension};
    auto all = run_of(scene, options);
    CHECK(all->bytes_per_body() - few->bytes_per_body() == 4 * sizeof(double));
    few->advance(2);
    all->advance(2);
    hits += static_cast<int>(few->counts().hits);
    CHECK(bits_of(scene, *few) == bits_of(scene, *all));
    auto again = run_of(scene, stepped(0.01));
    again->restore(few->checkpoint());
    CHECK(bits_of(scene, *again) == bits_of(scene, *few));
  }
  CHECK(hits > 4 * axes);
}

TEST_CASE(
    "a smooth ball that moves in a plane or on a line keeps an angular velocity about any axis") {
  Scene scene = with_gravity(1, 0, 1, 1e-6);
  plan_scenes::wall(scene, Point::UnitZ(), 0);
  plan_scenes::ball(scene, 0.5, 1, {0, 0, 2}).angular_velocity = {3, 4, 12};
  PlanOptions options = stepped(0.1);
  options.overrides.with = {Effect::rotation};
  for (const double speed : {0.0, 1.0}) {  // on a line, in a plane
    scene.bodies[1].velocity = {speed, 0, 0};
    auto run = run_of(scene, options);
    run->advance(1);
    CHECK(run->angular_velocity(1) == scene.bodies[1].angular_velocity);
  }
}

TEST_CASE("the gyroscopic term includes angular velocities where rotation is off") {
  Scene scene = with_gravity(0, 0.5, 1, 1e-6);
  plan_scenes::wall(scene, Point::UnitZ(), 0);
  plan_scenes::box(scene, {0.5, 0.4, 0.3}, 1, {0, 0, 0.3});
  CHECK_FALSE(has_stage(*run_of(scene, without({Effect::rotation})), "rotation"));
  PlanOptions options = with({Effect::gyroscopic_term});
  options.overrides.without = {Effect::rotation, Effect::sleeping};
  auto run = run_of(scene, options);
  CHECK(has_stage(*run, "rotation"));
  // One number for its position and one for its velocity, and two for angular velocities that two
  // mirrors exclude.
  CHECK(run->bytes_per_body() == 4 * sizeof(double) + sizeof(contact::Quaternion<double>));
  run->advance(1);
  CHECK((run->position(1) - Point(0, 0, 0.3)).norm() <= 1e-9);
  CHECK(run->angular_velocity(1).norm() <= 1e-9);
}

TEST_CASE("an effect that is proven inactive gives the same bits when it is forced on") {
  const auto same = [](const Scene& scene, Effect effect, double step) {
    auto off = stepped(step);
    const auto plan = contact::plan_scene(scene, off);
    CAPTURE(contact::effect_name(effect));
    REQUIRE_FALSE(contact::decision_on(plan, effect).on);
    auto on = off;
    on.overrides.with = {effect};
    auto one = run_of(scene, off);
    auto other = run_of(scene, on);
    one->advance(scene.duration);
    other->advance(scene.duration);
    CHECK(one->counts().hits > 0);
    CHECK(bits_of(scene, *one) == bits_of(scene, *other));
  };
  Random random(9);
  for (int i = 0; i < generators::tried(24); ++i) {
    // Without gravity: balls in a box.
    Scene gas = plan_scenes::empty(random.chance(0.5) ? 1 : 0, 0, 2, 1e-3);
    plan_scenes::walls(gas, {3, 3, 3});
    for (int k = 0; k < 6; ++k) {
      const Point v = any_direction(random) * 3;
      plan_scenes::ball(gas, 0.3, random.uniform(1, 2), {0.6 + k % 2, 0.6 + k / 2 % 2, 0.6 + k / 4},
                        v);
    }
    same(gas, Effect::gravity, 0.02);
    same(gas, Effect::friction, 0.02);
    same(gas, Effect::broad_phase, 0.02);
    same(gas, Effect::rotation, 0.02);
    same(gas, Effect::penalty_contact, 0.02);
    if (gas.materials[0].restitution == 0) same(gas, Effect::restitution, 0.02);
    // With friction balls rotate, but need no gyroscopic term.
    gas.materials[0].friction = 0.4;
    same(gas, Effect::gyroscopic_term, 0.02);
  }
}
