// What a plan must not depend on: the order of the bodies, the units (bit for bit, for powers of
// two), and bodies that nothing can reach.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/plan/plan.hpp>
#include <vector>

#include "plan_scenes.hpp"
#include "support/generators.hpp"

using contact::Decision;
using contact::Effect;
using contact::Plan;
using contact::Scene;
using generators::Random;
using plan_scenes::Point;

namespace {

Point random_point(Random& random, double size) {
  const double x = random.uniform(-size, size);
  const double y = random.uniform(-size, size);
  return {x, y, random.uniform(-size, size)};
}

/// Balls and boxes over a floor or in free space, apart from each other.
Scene crowded_scene(Random& random) {
  const double e = random.chance(0.5) ? 1.0 : random.uniform();
  const double friction = random.chance(0.5) ? 0.0 : random.uniform();
  const double duration = random.uniform(0.5, 5);
  Scene scene = plan_scenes::empty(e, friction, duration, random.uniform(1e-6, 1e-2));
  if (random.chance(0.7)) scene.gravity = {0, 0, -random.uniform(1, 10)};
  if (random.chance(0.2)) scene.materials[0].stiffness = random.uniform(1e3, 1e5);
  const bool floor = random.chance(0.6);
  if (floor) plan_scenes::wall(scene, Point::UnitZ(), -8);
  const bool flat = random.chance(0.3);
  const int bodies = random.integer(1, 5);
  for (int k = 0; k < bodies; ++k) {
    Point velocity = random_point(random, 4);
    if (flat) velocity.y() = 0;
    const double mass = random.uniform(0.1, 4);
    const Point position(4.0 * k, 0, random.uniform(-4, 4));
    const double size = random.uniform(0.1, 1);
    if (random.chance(0.6)) {
      plan_scenes::ball(scene, size, mass, position, velocity);
    } else {
      const double other = random.uniform(0.1, 1);
      auto& box = plan_scenes::box(scene, {size, other, size}, mass, position, velocity);
      if (!flat) box.angular_velocity = random_point(random, 2);
    }
  }
  return scene;
}

/// Everything that a reader sees of two plans: decisions, both sides of what decided, words.
void same(const Plan& a, const Plan& b, double length, double time) {
  REQUIRE(a.decisions.size() == b.decisions.size());
  CHECK(a.step * time == b.step);
  CHECK(a.speed * (length / time) == b.speed);
  CHECK(a.pairs == b.pairs);
  for (std::size_t i = 0; i < a.decisions.size(); ++i) {
    const Decision& one = a.decisions[i];
    const Decision& other = b.decisions[i];
    INFO(contact::effect_name(one.effect));
    REQUIRE(one.on == other.on);
    REQUIRE(one.proven == other.proven);
    REQUIRE(one.error * length == other.error);
    REQUIRE(one.saving.instructions == other.saving.instructions);
    REQUIRE(one.value.has_value() == other.value.has_value());
    if (one.value) REQUIRE(*one.value * time == *other.value);
    REQUIRE(one.because.size() == other.because.size());
    for (std::size_t k = 0; k < one.because.size(); ++k) {
      const auto& left = one.because[k];
      const auto& right = other.because[k];
      double scale = 1;
      if (left.unit == "m") scale = length;
      if (left.unit == "s") scale = time;
      if (left.unit == "m/s") scale = length / time;
      if (left.unit == "m/s²") scale = length / time / time;
      if (left.unit == "rad/s") scale = 1 / time;
      if (left.unit == "kg·m²") continue;
      INFO(left.left_is << ", " << right.left_is);
      REQUIRE(left.left * scale == right.left);
      REQUIRE(left.right * scale == right.right);
      REQUIRE(left.left_is == right.left_is);
    }
  }
}

}  // namespace

TEST_CASE("a plan does not depend on the order of the bodies, to the last bit") {
  Random random(30);
  for (int trial = 0; trial < generators::tried(1000); ++trial) {
    const Scene scene = crowded_scene(random);
    Scene shuffled = scene;
    for (std::size_t k = shuffled.bodies.size(); k > 1; --k) {
      const int other = random.integer(0, static_cast<int>(k) - 1);
      std::swap(shuffled.bodies[k - 1], shuffled.bodies[static_cast<std::size_t>(other)]);
    }
    same(contact::plan_scene(scene), contact::plan_scene(shuffled), 1, 1);
  }
}

TEST_CASE("a plan does not depend on the units, to the last bit for powers of two") {
  Random random(31);
  for (int trial = 0; trial < generators::tried(1000); ++trial) {
    const Scene scene = crowded_scene(random);
    const double length = std::ldexp(1.0, random.integer(-12, 12));
    const double time = std::ldexp(1.0, random.integer(-12, 12));
    const double mass = std::ldexp(1.0, random.integer(-12, 12));
    Scene scaled = scene;
    scaled.gravity *= length / time / time;
    scaled.duration *= time;
    *scaled.tolerance.position *= length;
    for (auto& material : scaled.materials) {
      if (material.stiffness) *material.stiffness *= mass / time / time;
    }
    for (auto& body : scaled.bodies) {
      body.position *= length;
      body.velocity *= length / time;
      body.angular_velocity /= time;
      body.mass *= mass;
      body.inertia *= mass * length * length;
      if (auto* ball = std::get_if<contact::BallShape>(&body.shape)) ball->radius *= length;
      if (auto* box = std::get_if<contact::BoxShape>(&body.shape)) box->half_lengths *= length;
      if (auto* wall = std::get_if<contact::HalfSpaceShape>(&body.shape)) wall->offset *= length;
    }
    // A frame of a sixtieth of a second is not a number of the scene: set a step instead.
    contact::PlanOptions first;
    contact::PlanOptions second;
    first.step = scene.duration / 64;
    second.step = scaled.duration / 64;
    same(contact::plan_scene(scene, first), contact::plan_scene(scaled, second), length, time);
  }
}

TEST_CASE("a body that nothing can reach changes no decision on the others") {
  Random random(32);
  for (int trial = 0; trial < generators::tried(1000); ++trial) {
    const Scene scene = crowded_scene(random);
    Scene more = scene;
    // It flies as the others do, with its centre in the plane of those that stay in one.
    plan_scenes::ball(more, 0.5, 1, {1e7, 0, 1e7}, scene.bodies.back().velocity);
    const Plan plan = contact::plan_scene(scene);
    const Plan with = contact::plan_scene(more);
    CHECK(plan.pairs == with.pairs);
    CHECK(plan.step == with.step);
    for (const Effect effect : contact::all_effects) {
      // Costs and precision are exceptions: one more body to sort, and a distant position in float.
      if (effect == Effect::broad_phase || effect == Effect::double_precision) continue;
      const Decision& one = contact::decision_on(plan, effect);
      const Decision& other = contact::decision_on(with, effect);
      // Nor does motion along a line stay one if the new body moves otherwise; it moves as one of
      // the old, so it does. Horizons use the largest coordinate.
      if (effect == Effect::horizon) continue;
      INFO("trial " << trial << ", " << contact::effect_name(effect));
      REQUIRE(one.on == other.on);
    }
  }
}
