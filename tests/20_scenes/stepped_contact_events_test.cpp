// Scenes step by step: the instants within a step at which a contact's force changes, compared with
// closed forms. Sliding ends, a ball begins to roll, a body passes the edge that supports it.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>
#include <contact/scene/kept_tolerance.hpp>
#include <contact/scene/make_scene_run.hpp>
#include <contact/scene/scene_runs.hpp>
#include <string>

#include "plan_scenes.hpp"
#include "stepped_scenes.hpp"
#include "support/generators.hpp"

using contact::Scene;
using generators::Random;
using plan_scenes::Point;
using plan_scenes::run_of;
using stepped_scenes::with_gravity;

namespace {

/// A cube of 0.1 m that slides on a floor at 6 m/s.
Scene sliding_cube(double tolerance) {
  Scene scene = plan_scenes::empty(0, 0.5, 2, tolerance);
  scene.gravity = Point(0, 0, -9.81);
  plan_scenes::wall(scene, Point::UnitZ(), 0);
  plan_scenes::box(scene, Point(0.05, 0.05, 0.05), 1, {0, 0, 0.05}, {6, 0, 0});
  return scene;
}

/// A ball of radius r that rolls on a table, whose edge is at x = 0.5.
Scene rolling_ball(double r, double x, double v, double g) {
  Scene scene = plan_scenes::empty(0.8, 0.3, 1, 1e-6);
  scene.gravity = Point(0, 0, -g);
  plan_scenes::box(scene, {0.5, 0.5, 0.4}, 0, {0, 0, 0});
  auto& ball = plan_scenes::ball(scene, r, 1, {x, 0, 0.4 + r}, {v, 0, 0});
  ball.angular_velocity = Point(0, v / r, 0);
  return scene;
}

/// What a run of the scene is known to keep, at its end.
contact::KeptTolerance kept_by(const Scene& scene) {
  const auto plan = contact::plan_scene(scene);
  auto run = contact::scenes::make_run(scene, plan);
  run->advance(scene.duration);
  return contact::kept_tolerance(plan, *run);
}

}  // namespace

TEST_CASE("a sliding cube stops after v²/(2 μ g), within whatever tolerance") {
  for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
    const Scene scene = sliding_cube(tolerance);
    auto run = run_of(scene);
    run->advance(scene.duration);
    CAPTURE(tolerance, run->position(1).x());
    CHECK(std::abs(run->position(1).x() - 36 / (2 * 0.5 * 9.81)) <= 1e-9);
  }
}

TEST_CASE("flat blocks of any size lose no distance where the solver's residual lifts them") {
  Random random(3);
  for (int i = 0; i < 16; ++i) {
    const double mu = random.uniform(0.1, 0.6);
    const double v = random.uniform(1, 6);
    const double time = random.uniform(0.5, 1.5) * v / (mu * 9.81);
    // The looser the tolerance, the larger the residual that the solver may leave.
    Scene scene = plan_scenes::empty(0, mu, time, 1e-3);
    scene.gravity = Point(0, 0, -9.81);
    plan_scenes::wall(scene, Point::UnitZ(), 0);
    const Point half{random.uniform(0.3, 0.6), random.uniform(0.2, 0.4), random.uniform(0.05, 0.2)};
    plan_scenes::box(scene, half, 1, {0, 0, half.z()}, {v, 0, 0});
    auto run = run_of(scene);
    run->advance(time);
    const double slides = std::min(time, v / (mu * 9.81));
    CAPTURE(i, mu, v, time, run->position(1).x());
    CHECK(std::abs(run->position(1).x() - slides * (v - mu * 9.81 * slides / 2)) <= 1e-7);
  }
}

TEST_CASE("a sliding cube stops at v/(μ g), in the middle of a step") {
  const Scene scene = sliding_cube(1e-6);
  auto run = run_of(scene);
  const double stop = 6 / (0.5 * 9.81);
  run->advance(stop - 1e-4);
  CHECK(std::abs(run->velocity(1).x() - 0.5 * 9.81 * 1e-4) <= 1e-8);
  run->advance(stop + 1e-4);
  CHECK(std::abs(run->velocity(1).x()) <= 1e-8);
}

TEST_CASE("a block that slides up a slope turns back at rest, and slides down more slowly") {
  // Up with g (sin + μ cos), down with g (sin − μ cos).
  Random random(1);
  for (int i = 0; i < generators::tried(16); ++i) {
    const double mu = random.uniform(0.1, 0.6);
    const double v = random.uniform(1, 4);
    Scene scene = with_gravity(0, mu, 1, 1e-6);
    plan_scenes::wall(scene, {0.6, 0, 0.8}, 0);
    const Point up(-0.8, 0, 0.6);
    auto& block = plan_scenes::box(scene, {1, 0.5, 0.25}, 2, Point(0.6, 0, 0.8) * 0.25, up * v);
    block.orientation = {3 / std::sqrt(10.0), {0, 1 / std::sqrt(10.0), 0}};
    const double slows = 6 + 8 * mu;
    const double stop = v / slows;
    const double rest = std::max(0.0, 1 - stop);
    const double truth = v * v / (2 * slows) - (6 - 8 * mu) * rest * rest / 2;
    const Point start = block.position;
    auto run = run_of(scene);
    run->advance(1);
    const double way = up.dot(Point(run->position(1) - start));
    CAPTURE(mu, v, way, truth);
    CHECK(std::abs(way - truth) <= 1e-8);
  }
}

TEST_CASE("a ball that slides rolls from 2 v/(7 μ g) on, with 5/7 of its speed") {
  Random random(2);
  for (int i = 0; i < generators::tried(16); ++i) {
    const double mu = random.uniform(0.1, 0.6);
    const double v = random.uniform(1, 4);
    const double rolls = 2 * v / (7 * mu * 10);
    Scene scene = with_gravity(0, mu, rolls + 0.5, 1e-6);
    plan_scenes::wall(scene, Point::UnitZ(), 0);
    plan_scenes::ball(scene, 0.1, 1, {0, 0, 0.1}, {v, 0, 0});
    auto run = run_of(scene);
    run->advance(scene.duration);
    const double truth = v * rolls - mu * 10 * rolls * rolls / 2 + 0.5 * v * 5 / 7;
    CAPTURE(mu, v, run->position(1).x(), truth);
    CHECK(std::abs(run->position(1).x() - truth) <= 1e-8);
  }
}

TEST_CASE("a ball that rolls over an edge faster than √(g r) falls freely from there") {
  // The edge is passed at the end of a step, or anywhere in one.
  for (const double x : {0.3, 0.31, 0.2987654321, 0.5 - 1e-9}) {
    const Scene scene = rolling_ball(0.1, x, 2, 9.81);
    auto run = run_of(scene);
    const double edge = (0.5 - x) / 2;
    const double later = edge + 0.07;
    run->advance(later);
    const double height = 0.5 - 9.81 * (later - edge) * (later - edge) / 2;
    CAPTURE(x, run->position(1).z(), height);
    CHECK(std::abs(run->position(1).z() - height) <= 1e-9);
    CHECK(std::abs(run->position(1).x() - (x + 2 * later)) <= 1e-9);
  }
}

TEST_CASE("a capsule that rolls over an edge faster than √(g r) falls freely from there") {
  Scene scene = plan_scenes::empty(0.8, 0.3, 1, 1e-6);
  scene.gravity = Point(0, 0, -9.81);
  plan_scenes::box(scene, {0.5, 0.5, 0.4}, 0, {0, 0, 0});
  auto& capsule = plan_scenes::add(scene, contact::CapsuleShape{0.1, 0.2}, 1, {0.31, 0, 0.5});
  capsule.orientation = {std::sqrt(0.5), {std::sqrt(0.5), 0, 0}};  // its axis along y
  capsule.velocity = Point(2, 0, 0);
  capsule.angular_velocity = Point(0, 20, 0);
  auto run = run_of(scene);
  const double edge = 0.19 / 2;
  const double later = edge + 0.07;
  run->advance(later);
  CHECK(std::abs(run->position(1).z() - (0.5 - 9.81 * 0.07 * 0.07 / 2)) <= 1e-8);
  CHECK(std::abs(run->position(1).x() - (0.31 + 2 * later)) <= 1e-8);
}

TEST_CASE("a smooth ball that slides over an edge takes off at cos θ = 2/3 + v²/(3 g r)") {
  // Its energy gives the speed, v² = g r cos θ the take-off; after that vx is constant. Forces vary
  // with the angle, so the error is one of the step: it decreases with its length.
  Scene scene = rolling_ball(0.1, 0.45, 0.5, 9.81);
  scene.materials[0].friction = 0;
  scene.materials[0].restitution = 0;
  const double cosine = 2.0 / 3 + 0.25 / (3 * 0.981);
  const double truth = std::sqrt(0.981) * std::pow(cosine, 1.5);
  double last = 0.05 * truth;
  for (const double step : {1.0 / 120, 1.0 / 960}) {
    contact::PlanOptions options;
    options.step = step;
    auto run = run_of(scene, options);
    run->advance(0.5);
    const double error = std::abs(run->velocity(1).x() - truth);
    CAPTURE(step, run->velocity(1).x(), truth);
    CHECK(run->position(1).z() < 0.4);
    CHECK(error <= last);
    last = error / 2;
  }
}

TEST_CASE("a run whose forces are constant between events keeps the tolerance in the whole run") {
  const auto kept = GENERATE(kept_by(sliding_cube(1e-4)), kept_by(rolling_ball(0.1, 0.3, 2, 9.81)));
  CAPTURE(kept.why, kept.until);
  CHECK(kept.whole());
  CHECK(kept.by == contact::KeptBy::estimate);
}

TEST_CASE("a run keeps the tolerance until a force varies within a step") {
  // A ball falls on a fixed ball beside its top, and rolls down.
  Scene hill = with_gravity(0, 0.5, 1, 1e-6);
  plan_scenes::ball(hill, 1, 0, {0, 0, -1});
  plan_scenes::ball(hill, 0.1, 1, {0, 0, 0.3}, {0.5, 0, 0});
  const auto kept = kept_by(hill);
  // It meets the fixed ball after a fall of 0.2 m, less what it passes over.
  const double falls = std::sqrt(2 * 0.2 / 10);
  CAPTURE(kept.why, kept.until, falls);
  CHECK_FALSE(kept.whole());
  CHECK(kept.until >= falls - 1.0 / 60);
  CHECK(kept.until <= falls + 2.0 / 60);
}

TEST_CASE("a run keeps no tolerance without an effect that can matter") {
  const Scene scene = sliding_cube(1e-4);
  const auto plan = contact::plan_scene(scene, stepped_scenes::without({contact::Effect::gravity}));
  auto run = contact::scenes::make_run(scene, plan);
  run->advance(1);
  CHECK(contact::kept_tolerance(plan, *run).by == contact::KeptBy::nothing);
}

TEST_CASE("a plan does not say until when the tolerance holds if an error has no bound") {
  const auto plan = contact::plan_scene(rolling_ball(0.1, 0.3, 2, 9.81));
  REQUIRE(std::isinf(plan.error));
  std::string all;
  for (const std::string& notice : plan.notices) all += notice;
  CHECK(all.find("The tolerance holds up to") == std::string::npos);
  CHECK(all.find("an error that is accepted has no bound") != std::string::npos);
}
