// Scenes step by step: crowds, of which all impacts of a step are taken at once.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <cstdint>

#include "plan_at_edge.hpp"
#include "plan_scenes.hpp"
#include "stepped_scenes.hpp"
#include "support/generators.hpp"

using contact::Effect;
using contact::Scene;
using generators::Random;
using plan_scenes::Point;
using plan_scenes::run_of;
using stepped_scenes::any_direction;
using stepped_scenes::has_stage;
using stepped_scenes::total_momentum;
using stepped_scenes::with;
using stepped_scenes::with_gravity;
using stepped_scenes::without;

TEST_CASE("in a crowd all impacts of a step are processed at once, and nothing leaves its box") {
  Random random(10);
  Scene scene = with_gravity(0.5, 0.3, 1, 1e-3);
  plan_scenes::walls(scene, {2, 2, 40});
  for (int k = 0; k < 100; ++k) {
    const double x = 0.45 + 0.5 * (k % 4) + random.uniform(-0.01, 0.01);
    const double y = 0.45 + 0.5 * (k / 4 % 4) + random.uniform(-0.01, 0.01);
    plan_scenes::ball(scene, 0.15, 1, {std::min(x, 1.8), std::min(y, 1.8), 0.5 + 0.4 * (k / 16)});
  }
  auto run = run_of(scene);
  CHECK_FALSE(has_stage(*run, "time of impact"));
  const double energy = run->energy();
  run->advance(1);
  CHECK(run->counts().hits > 100);
  CHECK(run->energy() < energy);
  for (std::size_t i = 6; i < scene.bodies.size(); ++i) {
    CAPTURE(i);
    for (int k = 0; k < 2; ++k) {
      CHECK(run->position(i)(k) > 0.1);
      CHECK(run->position(i)(k) < 1.9);
    }
    CHECK(run->position(i).z() > 0.1);
  }
}

namespace {

/// Bodies on a lattice with 0.4 m between them, with random velocities and angular velocities.
template <class Add>
Scene lattice_of(int count, const Point& gravity, const Add& add) {
  Scene scene = plan_scenes::empty(1, 0, 1, 1e-3);
  scene.gravity = gravity;
  const int side = static_cast<int>(std::ceil(std::cbrt(count)));
  plan_scenes::walls(scene, Point::Constant(1.4 * side));
  Random random(21);
  for (int k = 0; k < count; ++k) {
    const Point cell(k % side, k / side % side, k / side / side);
    contact::SceneBody& body = add(scene, (cell + Point::Constant(0.5)) * 1.4);
    body.velocity = any_direction(random) * 2;
    body.angular_velocity = any_direction(random);
  }
  return scene;
}

contact::SceneBody& lattice_ball(Scene& scene, const Point& at) {
  return plan_scenes::ball(scene, 0.5, 1, at);
}

contact::SceneBody& lattice_box(Scene& scene, const Point& at) {
  return plan_scenes::box(scene, {0.3, 0.25, 0.35}, 1, at);
}

}  // namespace

TEST_CASE("an elastic crowd conserves its energy, though its impacts are processed at once") {
  for (const bool boxes : {false, true}) {
    CAPTURE(boxes);
    const Scene scene = lattice_of(100, Point::Zero(), boxes ? lattice_box : lattice_ball);
    const auto run = run_of(scene, without({Effect::event_driven}));
    REQUIRE_FALSE(run->event_driven());
    const double energy = run->energy();
    run->advance(generators::sanitized ? 0.25 : 1);
    CHECK(run->counts().hits > (generators::sanitized ? 40 : 200));
    // Vertices rotate on while they come to touch, and overlaps are pushed out.
    CHECK(std::abs(run->energy() - energy) < (boxes ? 1e-3 : 1e-6) * energy);
  }
}

TEST_CASE("a crowd of light and heavy balls conserves its energy, and no ball penetrates another") {
  // Iterations alone lose a thousandth, and overlap by a ninth of a ball; a ball that is thrown out
  // between two heavy ones meets another that was not near before.
  for (const double heavy : {1e3, 1e6}) {
    CAPTURE(heavy);
    Scene scene = lattice_of(100, Point::Zero(), lattice_ball);
    for (std::size_t i = 6; i < scene.bodies.size(); ++i) {
      if (i % 2 == 0) continue;
      scene.bodies[i].mass *= heavy;
      scene.bodies[i].inertia *= heavy;
    }
    const auto run = run_of(scene, without({Effect::event_driven}));
    const double energy = run->energy();
    run->advance(1);
    CHECK(run->counts().hits > 200);
    CHECK(std::abs(run->energy() - energy) < 1e-7 * energy);
    CHECK(run->counts().largest_overlap < 1.0 / 64);
  }
}

TEST_CASE("a load that falls on what lies on a floor gains no energy, however often they hit") {
  // A step has too many impacts to take them one by one. What stops the load does so for the rest
  // of the step, while gravity goes on to change its velocity: turned around by restitution, that
  // change would be 3e-3 of the energy.
  for (const bool boxes : {false, true}) {
    for (const double friction : {0.0, 0.5}) {
      for (const double load : {1e3, 1e6}) {
        CAPTURE(boxes, friction, load);
        Scene scene = with_gravity(1, friction, 0.4, 1e-6);
        plan_scenes::wall(scene, {0, 0, 1}, 0);
        if (boxes)
          plan_scenes::box(scene, {0.5, 0.5, 0.25}, 1, {0, 0, 0.3});
        else
          plan_scenes::ball(scene, 0.5, 1, {0, 0, 0.6});
        const double height = boxes ? 1.4 : 1.8;
        plan_scenes::box(scene, {0.5, 0.5, 0.5}, load, {0.05, 0.02, height}, {0.3, 0.1, -1});
        const auto run = run_of(scene, without({Effect::event_driven}));
        const double energy = run->energy();
        for (int k = 1; k <= 24; ++k) {
          run->advance(k / 60.0);
          CAPTURE(k);
          // An overlap of 1e-7 m is pushed out, which lifts the load.
          CHECK(run->energy() <= energy * (1 + 1e-7));
        }
        CHECK(run->counts().crowded_steps > 0);
      }
    }
  }
}

TEST_CASE("in a crowd a body that touches one that is hit reacts at once") {
  // With the mean of its velocities it would be late by half a step's motion: a tenth of a ball.
  Scene scene = plan_scenes::empty(0, 0, 0.1, 1e-3);
  scene.gravity.setZero();
  plan_scenes::ball(scene, 0.5, 1000, {0, 0, 0}, {100, 0, 0});
  plan_scenes::ball(scene, 0.5, 1, {1.25, 0, 0});
  plan_scenes::ball(scene, 0.5, 1, {2.25, 0, 0});
  for (int k = 0; k < 70; ++k) plan_scenes::ball(scene, 0.5, 1, {0, 5.0 + 2 * k, 0});
  const auto run = run_of(scene);
  run->advance(0.05);
  CHECK(run->velocity(2).x() > 90);
  CHECK(run->counts().largest_overlap < 1e-6);
}

TEST_CASE("a heavy piston does not squeeze a jammed crowd with friction") {
  Scene scene = plan_scenes::empty(0, 0.5, 0.5, 1e-3);
  scene.gravity.setZero();
  plan_scenes::walls(scene, {5, 5, 5});
  plan_scenes::box(scene, {2.45, 2.45, 0.5}, 1e5, {2.5, 2.5, 4}, {0, 0, -5});
  Random random(12);
  for (int k = 0; k < 75; ++k) {
    const Point cell(k % 5, k / 5 % 5, k / 25);
    plan_scenes::box(scene, {0.35, 0.3, 0.25}, 1, cell + Point::Constant(0.5)).velocity =
        any_direction(random);
  }
  const auto run = run_of(scene);
  run->advance(0.5);
  CHECK(run->energy() < 1e-3 * 1.25e6);
  CHECK(run->counts().largest_overlap < 0.05);
}

TEST_CASE("a crowd that meets no wall conserves its momentum, with friction or without") {
  for (const double friction : {0.0, 0.5}) {
    if (generators::sanitized && friction == 0) continue;
    CAPTURE(friction);
    Scene scene = lattice_of(70, Point::Zero(), lattice_box);
    scene.bodies.erase(scene.bodies.begin(), scene.bodies.begin() + 6);
    scene.materials[0].friction = friction;
    const auto run = run_of(scene);
    const Point moving = total_momentum(scene, *run);
    const double energy = run->energy();
    run->advance(0.5);
    CHECK(run->counts().hits > 20);
    CHECK((total_momentum(scene, *run) - moving).norm() < 1e-11);
    CHECK(run->energy() < energy * (friction > 0 ? 0.99 : 1.0001));
  }
}

TEST_CASE("in a crowd each ball bounces to e² of its height, and two of one mass exchange speeds") {
  Scene scene = with_gravity(0.8, 0, 1, 1e-3);
  plan_scenes::wall(scene, Point::UnitZ(), 0);
  for (int k = 0; k < 70; ++k) plan_scenes::ball(scene, 0.1, 1 + k, Point(k, 0, 0.2 + 0.01 * k));
  const auto run = run_of(scene, without({Effect::event_driven}));
  run->advance(0.48);  // the lowest has not landed again, the highest has
  for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
    CAPTURE(i);
    const double drop = scene.bodies[i].position.z() - 0.1;
    const double speed = run->velocity(i).z();
    const double apex = run->position(i).z() - 0.1 + speed * speed / 20;
    const double down = std::sqrt(drop / 5);
    if (down < 0.46 && 2.6 * down > 0.5) CHECK(std::abs(apex - 0.64 * drop) <= 1e-12);
  }
  Scene pairs = plan_scenes::empty(1, 0, 1, 1e-3);
  for (int k = 0; k < 35; ++k) {
    plan_scenes::ball(pairs, 0.1, 1, Point(0, k, 0), Point(1 + k, 0, 0));
    plan_scenes::ball(pairs, 0.1, 1, Point(0.3, k, 0), Point(-2, 0, 0));
  }
  const auto swapped = run_of(pairs, without({Effect::event_driven}));
  swapped->advance(0.1);
  for (std::size_t k = 0; k < 35; ++k) {
    CAPTURE(k);
    CHECK(std::abs(swapped->velocity(2 * k).x() + 2) <= 1e-12 * 40);
    CHECK(std::abs(swapped->velocity(2 * k + 1).x() - 1 - static_cast<double>(k)) <= 1e-12 * 40);
  }
}

TEST_CASE("boxes that hit more often in a step than is taken one by one keep their restitution") {
  const Scene scene = lattice_of(20, Point(0, 0, -10), lattice_box);
  const auto run = run_of(scene);
  const double energy = run->energy();
  run->advance(1);
  CHECK(run->counts().crowded_steps > 0);
  CHECK(std::abs(run->energy() - energy) < 0.005 * energy);
  CHECK(run->counts().largest_overlap < 0.05);
}

TEST_CASE("in a crowd thin plates that meet face to face do not pass") {
  for (const double e : {0.0, 0.5, 1.0}) {
    if (generators::sanitized && e != 0.5) continue;
    CAPTURE(e);
    Scene scene = plan_scenes::empty(e, 0, 0.1, 1e-3);
    for (int k = 0; k < 35; ++k) {
      plan_scenes::box(scene, {0.02, 0.3, 0.2}, 1, {-0.5, 1.0 * k, 0}, {50, 0, 0});
      plan_scenes::box(scene, {0.02, 0.3, 0.2}, 1, {0.5, 1.0 * k, 0}, {-50, 0, 0});
    }
    const auto run = run_of(scene, with({Effect::continuous_detection}));
    run->advance(0.1);
    for (std::size_t i = 0; i < 70; i += 2) {
      CAPTURE(i);
      CHECK(run->position(i + 1).x() - run->position(i).x() > 0.039);
      CHECK(std::abs(run->velocity(i).x() + e * 50) < 1e-4);
      CHECK(std::abs(run->velocity(i + 1).x() - e * 50) < 1e-4);
    }
  }
}

TEST_CASE("thin plates that a hit rotates fast do not rotate through each other") {
  for (const std::size_t others : {0, 63}) {
    CAPTURE(others);
    Scene scene = plan_scenes::empty(0, 0.3, 0.05, 1e-3);
    plan_scenes::box(scene, {0.002, 0.3, 0.2}, 1, {-0.5, 0, 0}, {100, 0, 0}).angular_velocity = {
        0, 0.9, 0.6};
    plan_scenes::box(scene, {0.002, 0.3, 0.2}, 1, {0.5, 0, 0}, {-100, 0, 0}).angular_velocity = {
        0, -0.6, 0.4};
    for (std::size_t k = 0; k < others; ++k)
      plan_scenes::ball(scene, 0.1, 1, {100, static_cast<double>(k), 0});
    const auto run = run_of(scene);
    for (int k = 1; k <= 20; ++k) {
      run->advance(0.05 * k / 20);
      CHECK(run->position(0).x() < run->position(1).x());
    }
    CHECK(run->counts().hits > 0);
    CHECK(run->counts().largest_overlap < 0.002);
  }
}

TEST_CASE("plates meet at their edges, though their angular velocities change without torque") {
  // A plate's angular velocity changes direction within a step. If it were taken as constant,
  // plates would penetrate each other by several thicknesses; and where two edges almost touch, a
  // wrong normal looks like endless hits.
  Random random(31);
  std::uint64_t hits = 0;
  std::uint64_t crowded = 0;
  const int scenes = generators::tried(48);
  for (int n = 0; n < scenes; ++n) {
    CAPTURE(n);
    const double half = n % 2 == 0 ? 0.002 : 0.05;
    Scene scene = plan_scenes::empty(1, 0, 0.6, 1e-6);
    for (const double side : {-0.5, 0.5}) {
      const Point aside = any_direction(random) * 0.1;
      auto& plate = plan_scenes::box(scene, {0.25, 0.25, half}, 1, Point(side, 0, 0) + aside,
                                     Point(-4 * side, 0, 0));
      plate.orientation = contact::exponential<double>(any_direction(random) * 3.0);
      plate.angular_velocity = any_direction(random) * 50;
    }
    const auto run = run_of(scene);
    const double energy = run->energy();
    run->advance(0.6);
    CHECK(run->counts().largest_overlap < 1e-3 * half);
    CHECK(std::abs(run->energy() - energy) < 1e-11 * energy);
    hits += run->counts().hits;
    crowded += run->counts().crowded_steps;
  }
  CHECK(hits > static_cast<std::uint64_t>(scenes * 5 / 6));
  CHECK(crowded < hits / 4);
}
