// Bodies that meet nothing fly by a formula: right at any time, with only the numbers that the plan
// needs, and never where bodies may meet or an angular velocity may change.
#include <algorithm>
#include <bit>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/scene/free_flight_run.hpp>
#include <contact/scene/make_scene_run.hpp>
#include <contact/scene/scene_file.hpp>
#include <contact/scene/scene_runs.hpp>
#include <contact/tolerance.hpp>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include "plan_scenes.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

using contact::Effect;
using contact::PlanOptions;
using contact::Scene;
using contact::SceneRun;
using generators::Random;
using oracle::Rational;
using plan_scenes::Point;
using plan_scenes::run_of;

namespace {

bool flies(const Scene& scene, const PlanOptions& options = {}) {
  return contact::flies_freely(contact::plan_scene(scene, options));
}

Point any_vector(Random& random, double size) {
  return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

/// Bodies so far from each other that none meets another.
Scene far_apart(Random& random, double tolerance) {
  Scene scene = plan_scenes::empty(1, 0.5, random.uniform(0.5, 4), tolerance);
  scene.gravity = any_vector(random, 10);
  const int count = random.integer(1, 4);
  for (int i = 0; i < count; ++i) {
    const Point place = Point(1000.0 * i, 0, 0) + any_vector(random, 5);
    const Point speed = any_vector(random, 20);
    if (random.integer(0, 1) == 0)
      plan_scenes::ball(scene, 0.25, 2, place, speed);
    else
      plan_scenes::box(scene, {0.5, 0.25, 0.125}, 3, place, speed);
  }
  return scene;
}

using oracle::exact;

/// x + v t + g t²/2, exactly, and the sum of the terms' sizes.
struct Place {
  Rational at;
  double size;
};
Place place_of(const Scene& scene, std::size_t body, int k, double t) {
  const contact::SceneBody& b = scene.bodies[body];
  const double g = scene.gravity(k);
  return {exact(b.position(k)) + exact(b.velocity(k)) * exact(t) +
              exact(g) * exact(t) * exact(t) / Rational(2),
          std::abs(b.position(k)) + std::abs(b.velocity(k) * t) + std::abs(g * t * t / 2)};
}

}  // namespace

TEST_CASE("a free flight is on its parabola at any time, in any order of calls") {
  Random random(41);
  for (int i = 0; i < generators::tried(300); ++i) {
    const Scene scene = far_apart(random, 1e-12);
    REQUIRE(flies(scene));
    auto run = run_of(scene);
    for (int look = 1; look <= 3; ++look) {
      const double t = scene.duration * look / 3;
      REQUIRE(run->advance(t) == contact::SceneRunEnd::reached);
      for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
        for (int k = 0; k < 3; ++k) {
          const Place right = place_of(scene, body, k, t);
          const Rational off = abs(exact(run->position(body)(k)) - right.at);
          CHECK(off <= exact(8 * contact::tolerance::unit_roundoff<double> * right.size));
        }
      }
    }
    CHECK(run->counts().steps == 0);
  }
}

TEST_CASE("in float its error is less than the plan says") {
  Random random(42);
  int floats = 0;
  for (int i = 0; i < generators::tried(300); ++i) {
    const Scene scene = far_apart(random, random.uniform(1e-4, 1e-1));
    const auto plan = contact::plan_scene(scene);
    const contact::Decision& precision = decision_on(plan, Effect::double_precision);
    if (precision.on) continue;
    ++floats;
    auto run = run_of(scene);
    run->advance(scene.duration);
    for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
      for (int k = 0; k < 3; ++k) {
        const Place right = place_of(scene, body, k, scene.duration);
        CHECK(abs(exact(run->position(body)(k)) - right.at) <= exact(precision.error));
      }
    }
  }
  CHECK(floats > generators::tried(300) / 4);
}

TEST_CASE("in float the error of every vertex of a rotating body is less than the plan says") {
  Random random(43);
  int floats = 0;
  for (int i = 0; i < generators::tried(200); ++i) {
    Scene scene = plan_scenes::empty(1, 0.5, 3, 1e-2);
    const double half = random.uniform(0.1, 2);
    plan_scenes::box(scene, {half, half, half}, 1, any_vector(random, 10)).angular_velocity =
        any_vector(random, 20);
    const auto plan = contact::plan_scene(scene);
    const contact::Decision& precision = decision_on(plan, Effect::double_precision);
    if (precision.on) continue;
    ++floats;
    auto floating = run_of(scene);
    PlanOptions options;
    options.overrides.with = {Effect::double_precision};
    auto right = run_of(scene, options);
    REQUIRE(floating->bytes_per_body() < right->bytes_per_body());
    for (const double t : {1.0, 2.0, 3.0}) {
      floating->advance(t);
      right->advance(t);
      const Point corner(half, half, half);
      const Point here = contact::matrix_of(floating->orientation(0)) * corner;
      const Point there = contact::matrix_of(right->orientation(0)) * corner;
      const Point moved = floating->position(0) - right->position(0);
      CHECK((here - there + moved).norm() <= precision.error);
    }
  }
  CHECK(floats > generators::tried(200) / 2);
}

TEST_CASE("a constant angular velocity rotates as in steps of any length") {
  Random random(44);
  for (int i = 0; i < generators::tried(100); ++i) {
    Scene scene = plan_scenes::empty(1, 0.5, 2, 1e-9);
    contact::SceneBody& cube =
        plan_scenes::box(scene, {0.5, 0.5, 0.5}, 1, Point::Zero(), any_vector(random, 2));
    cube.angular_velocity = any_vector(random, 10);
    REQUIRE(flies(scene));
    auto run = run_of(scene);
    PlanOptions options;
    options.step = random.uniform(0.001, 0.1);
    REQUIRE_FALSE(flies(scene, options));
    auto steps = run_of(scene, options);
    run->advance(2);
    steps->advance(2);
    CHECK((contact::matrix_of(run->orientation(0)) - contact::matrix_of(steps->orientation(0)))
              .cwiseAbs()
              .maxCoeff() <= 1e-12);
    CHECK((run->position(0) - steps->position(0)).norm() <= 1e-12);
    CHECK(run->angular_velocity(0) == scene.bodies[0].angular_velocity);
  }
}

TEST_CASE("it stores the numbers that the plan needs, and no others") {
  const auto bytes = [](double tolerance, const Point& velocity, const Point& gravity,
                        const Point& angular_velocity, const PlanOptions& options = {}) {
    Scene scene = plan_scenes::empty(1, 0.5, 1, tolerance);
    scene.gravity = gravity;
    plan_scenes::box(scene, {0.5, 0.5, 0.5}, 1, {1, 2, 3}, velocity).angular_velocity =
        angular_velocity;
    const auto run = run_of(scene, options);
    run->advance(1);
    const Point right = Point(1, 2, 3) + velocity + gravity / 2;
    CHECK((run->position(0) - right).norm() <= tolerance);
    return run->bytes_per_body();
  };
  const Point zero = Point::Zero();
  SECTION("one coordinate of two floats") { CHECK(bytes(1e-2, {0, 1, 0}, zero, zero) == 8); }
  SECTION("one coordinate of two doubles") { CHECK(bytes(1e-9, {0, 1, 0}, zero, zero) == 16); }
  SECTION("two coordinates") { CHECK(bytes(1e-9, {2, 0, 0}, {0, 0, -10}, zero) == 32); }
  SECTION("three coordinates") { CHECK(bytes(1e-9, {2, 3, 0}, {0, 0, -10}, zero) == 48); }
  SECTION("a quaternion and a spin where it turns") {
    CHECK(bytes(1e-9, {2, 3, 0}, {0, 0, -10}, {1, 2, 3}) == 48 + 56);
  }
  SECTION("effects that are forced on") {
    PlanOptions options;
    options.overrides.with = {Effect::third_dimension, Effect::double_precision};
    CHECK(bytes(1e-2, {0, 1, 0}, zero, zero, options) == 48);
  }
}

TEST_CASE("gravity that the tolerance leaves out is left out of the formula") {
  Scene scene = plan_scenes::empty(1, 0, 1, 1e-2);
  scene.gravity = {0, 0, -1e-3};
  plan_scenes::ball(scene, 0.5, 1, Point::Zero(), {1, 0, 0});
  REQUIRE_FALSE(plan_scenes::is_on(scene, Effect::gravity));
  auto run = run_of(scene);
  run->advance(1);
  CHECK(run->position(0) == Point(1, 0, 0));
  CHECK(run->stages().size() == 1);
}

TEST_CASE("bodies that may meet, or change their angular velocity, do not fly by the formula") {
  Scene scene = plan_scenes::empty(1, 0, 1, 1e-3);
  plan_scenes::box(scene, {0.5, 0.25, 0.125}, 1, Point::Zero(), {1, 0, 0});
  REQUIRE(flies(scene));
  SECTION("a wall in the way") {
    plan_scenes::wall(scene, -Point::UnitX(), -1.4);
    CHECK_FALSE(flies(scene));
  }
  SECTION("an uneven body that spins about no axis of its own") {
    scene.bodies[0].angular_velocity = {1, 1, 1};
    CHECK_FALSE(flies(scene));
  }
  SECTION("somebody asks for steps") {
    PlanOptions options;
    options.overrides.without = {Effect::event_driven};
    CHECK_FALSE(flies(scene, options));
  }
}

TEST_CASE("float is not enough where only the rotation has too large an error") {
  Scene scene = plan_scenes::empty(1, 0, 100, 1e-3);
  contact::SceneBody& cube = plan_scenes::box(scene, {5, 5, 5}, 1, Point::Zero(), Point::Zero());
  REQUIRE_FALSE(plan_scenes::is_on(scene, Effect::double_precision));
  cube.angular_velocity = {0, 0, 10};
  CHECK(plan_scenes::is_on(scene, Effect::double_precision));
}

TEST_CASE("float is not enough where a gyroscopic term changes an angular velocity") {
  Scene scene = plan_scenes::empty(1, 0, 1, 1e-2);
  plan_scenes::box(scene, {0.5, 0.25, 0.125}, 1, Point::Zero(), Point::Zero()).angular_velocity = {
      1, 1, 1};
  REQUIRE(plan_scenes::is_on(scene, Effect::gyroscopic_term));
  CHECK(plan_scenes::is_on(scene, Effect::double_precision));
  CHECK_FALSE(plan_scenes::is_on(scene, Effect::event_driven));
}

TEST_CASE("a free flight goes on from a checkpoint with the same bits") {
  Random random(45);
  const Scene scene = far_apart(random, 1e-9);
  auto run = run_of(scene);
  run->advance(scene.duration / 2);
  const contact::SceneCheckpoint kept = run->checkpoint();
  run->advance(scene.duration);
  auto other = run_of(scene);
  other->restore(kept);
  CHECK(other->now() == scene.duration / 2);
  other->advance(scene.duration);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    for (int k = 0; k < 3; ++k)
      CHECK(std::bit_cast<std::uint64_t>(run->position(i)(k)) ==
            std::bit_cast<std::uint64_t>(other->position(i)(k)));
}

TEST_CASE("a free flight refuses a checkpoint of another kind") {
  Random random(46);
  auto run = run_of(far_apart(random, 1e-9));
  contact::SceneCheckpoint other;
  other.kind = "stepped";
  CHECK_THROWS_AS(run->restore(other), std::invalid_argument);
}

TEST_CASE("the book's scenes of free flights give what they expect") {
  const std::filesystem::path folder = CONTACT_SOURCE_DIR "/chapters/20_scenes/scenes";
  int tried = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    const Scene scene = contact::scenes::read_scene(file.path());
    if (!flies(scene)) continue;
    ++tried;
    CAPTURE(scene.name);
    for (const auto& wanted : scene.expect) {
      auto run = run_of(scene);
      run->advance(wanted.time);
      const double got = contact::scene_quantity(scene, *run, wanted);
      CHECK(std::abs(got - wanted.value) <= wanted.within);
    }
  }
  CHECK(tried >= 2);
}
