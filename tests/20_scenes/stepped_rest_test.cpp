// Scenes step by step: stacks stay, bodies that have been at rest sleep, and bodies under a load
// slide or come to rest by their slope.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/stepped/step_solver.hpp>
#include <vector>

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
using stepped_scenes::has_stage;
using stepped_scenes::with;
using stepped_scenes::with_gravity;
using stepped_scenes::without;

TEST_CASE("boxes on top of each other stay, with rotation or without") {
  for (const int count : {1, 3, 10}) {
    Scene scene = with_gravity(0, 0.5, 2, 1e-6);
    plan_scenes::wall(scene, Point::UnitZ(), 0);
    for (int i = 0; i < count; ++i) plan_scenes::box(scene, {0.5, 0.5, 0.5}, 1, {0, 0, 0.5 + i});
    for (const PlanOptions& options :
         {PlanOptions{}, with({Effect::rotation}), without({Effect::sleeping}),
          without({Effect::continuous_detection})}) {
      auto run = run_of(scene, options);
      run->advance(2);
      for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
        CAPTURE(count, i);
        // The residual of the iterations, below the tolerance by a factor of ten.
        CHECK((run->position(i) - scene.bodies[i].position).norm() <= 1e-7);
        CHECK(run->velocity(i).norm() <= 1e-7);
      }
    }
  }
}

TEST_CASE("a body that has been at rest for a second sleeps, and wakes when it is hit") {
  Scene scene = with_gravity(0, 0.5, 3, 1e-6);
  plan_scenes::wall(scene, Point::UnitZ(), 0);
  plan_scenes::box(scene, {0.5, 0.5, 0.5}, 1, {0, 0, 0.5});
  plan_scenes::box(scene, {0.5, 0.5, 0.5}, 1, {0, 0, 1.5});
  plan_scenes::ball(scene, 0.1, 1, {-5, 0, 1.5}, {3, 0, 7});
  auto run = run_of(scene);
  CHECK(has_stage(*run, "sleep"));
  run->advance(1);
  CHECK(run->counts().rests == 2);
  CHECK((run->position(2) - Point(0, 0, 1.5)).norm() <= 1e-9);
  CHECK(run->velocity(2) == Point(0, 0, 0));
  run->advance(3);
  CHECK(run->position(2).x() > 0.01);
}

TEST_CASE("a creeping body does not sleep if it would move farther than the tolerance") {
  // A smooth slope of 1e-9: in 100 s a block moves ½ · 1e-8 · 1e4 m = 5e-5 m.
  Scene scene = with_gravity(0, 0, 100, 1e-6);
  scene.gravity = {1e-8, 0, -10};
  plan_scenes::wall(scene, Point::UnitZ(), 0);
  plan_scenes::box(scene, {0.5, 0.5, 0.5}, 1, {0, 0, 0.5});
  auto run = run_of(scene, stepped(0.05));
  REQUIRE(has_stage(*run, "sleep"));
  run->advance(100);
  CHECK(std::abs(run->position(1).x() - 5e-5) <= 1e-9);
}

TEST_CASE("towers in a crowd are as much at rest as alone, and come to sleep") {
  Scene scene = with_gravity(0.3, 0.5, 2, 1e-3);
  plan_scenes::wall(scene, Point::UnitZ(), 0);
  for (int k = 0; k < 70; ++k)
    plan_scenes::box(scene, Point::Constant(0.5), 1, {4.0 * (k / 7), 0, 0.5 + k % 7});
  const auto run = run_of(scene);
  run->advance(2);
  for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
    CAPTURE(i);
    CHECK((run->position(i) - scene.bodies[i].position).norm() < 1e-3);
    CHECK(run->velocity(i).norm() == 0);
  }
}

TEST_CASE("a staggered tower is at rest and comes to sleep, whatever lies on what") {
  struct Tower {
    int boxes;
    double heavy;  // kg, of each second one or the topmost
    bool topmost;
    double most;  // m
  };
  for (const Tower& tower :
       {Tower{10, 1, true, 1e-12}, Tower{30, 1, true, 1e-11}, Tower{10, 1e3, true, 1e-9},
        Tower{10, 1e6, true, 1e-7}, Tower{20, 1e6, false, 1e-6}, Tower{40, 1e5, false, 1e-6}}) {
    CAPTURE(tower.boxes, tower.heavy, tower.topmost);
    Scene scene = with_gravity(0, 0.5, 1, 1e-3);
    plan_scenes::wall(scene, Point::UnitZ(), 0);
    for (int k = 0; k < tower.boxes; ++k) {
      const bool heavy = tower.topmost ? k == tower.boxes - 1 : k % 2 == 1;
      plan_scenes::box(scene, Point::Constant(0.5), heavy ? tower.heavy : 1,
                       {0.1 * (k % 2), 0, 0.5 + k});
    }
    const auto run = run_of(scene);
    run->advance(1);
    CHECK(run->counts().hits == 0);
    for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
      CAPTURE(i);
      CHECK((run->position(i) - scene.bodies[i].position).norm() < tower.most);
      CHECK(run->velocity(i).norm() == 0);
    }
  }
}

namespace {

/// Boxes on a slope of 3 in 4, each on the one before, the last one of another mass.
Scene boxes_on_a_slope(double friction, double load) {
  Scene scene = with_gravity(0, friction, 0.5, 1e-4);
  const Point normal(0.6, 0, 0.8);
  plan_scenes::wall(scene, normal, 0);
  double low = 0;
  for (const double half : {0.05, 0.05, 0.05, 0.25}) {
    auto& box =
        plan_scenes::box(scene, {0.5, 0.5, half}, half > 0.1 ? load : 1, normal * (low + half));
    // By the angle whose half has the cosine 3/√10: the box's z is the slope's normal.
    box.orientation = {3 / std::sqrt(10.0), {0, 1 / std::sqrt(10.0), 0}};
    low += 2 * half;
  }
  return scene;
}

}  // namespace

TEST_CASE("plates on a slope stay or slide by its angle, whatever lies on them") {
  // The forces on a plate under a load are a million times its weight. That rounds to 2⁻⁴⁰ of it a
  // step, and is still below 1e-7 m after thirty. A sliding plate is at its limit on both faces:
  // nothing brings it back once it has moved off the load by a little.
  for (const double load : {1.0, 1e3, 1e6}) {
    for (const double steep : {0.99, 1.01}) {  // times the friction angle's tangent
      const double friction = 0.75 / steep;
      const Scene scene = boxes_on_a_slope(friction, load);
      const auto run = run_of(scene);
      run->advance(0.5);
      const double way = std::max(0.0, 10 * (0.6 - friction * 0.8)) / 8;
      for (std::size_t i = 1; i <= 4; ++i) {
        const Point moved = run->position(i) - scene.bodies[i].position;
        CAPTURE(load, steep, i, way, moved);
        CHECK((moved - Point(0.8, 0, -0.6) * way).norm() < (way > 0 && i < 4 ? 1e-3 : 1e-7));
      }
    }
  }
}

TEST_CASE("a heavy box comes to rest on light ones, which rest or move with it") {
  // μ = 1/2: from 1 m/s it stops after 0.2 s and 0.1 m, or, if that is a rounding later than the
  // end of a step, up to μ g h²/8 farther.
  for (const double load : {1.0, 1e3, 1e6}) {
    for (const double carried : {0.0, 1.0}) {
      Scene scene = with_gravity(0, 0.5, 0.4, 1e-4);
      plan_scenes::wall(scene, Point::UnitZ(), 0);
      for (const double x : {-0.6, 0.6})
        plan_scenes::box(scene, {0.3, 0.5, 0.1}, 1, {x, 0, 0.1}, {carried, 0, 0});
      plan_scenes::box(scene, {1, 0.5, 0.25}, load, {0, 0, 0.45}, {1, 0, 0});
      const auto run = run_of(scene);
      for (const double t : {0.1, 0.4}) {
        run->advance(t);
        const double speed = std::max(0.0, 1 - 5 * t);
        const double way = 0.1 - speed * speed / 10;
        for (std::size_t i = 1; i <= 3; ++i) {
          CAPTURE(load, carried, t, i);
          const double share = i == 3 ? 1 : carried;
          const Point moved = run->position(i) - scene.bodies[i].position;
          const double late = speed > 0 ? 0 : 5 * run->step() * run->step() / 8;
          CHECK((moved - Point::UnitX() * (share * way)).norm() < 1e-6 + late);
          CHECK((run->velocity(i) - Point::UnitX() * (share * speed)).norm() < 1e-6);
        }
      }
    }
  }
}

TEST_CASE("a body that slides obliquely comes to rest on a straight line, whatever lies on it") {
  const Point way(0.8, 0.6, 0);
  for (const double load : {1.0, 1e3, 1e6}) {
    Scene scene = with_gravity(0, 0.4, 0.6, 1e-4);
    plan_scenes::wall(scene, Point::UnitZ(), 0);
    plan_scenes::box(scene, {0.5, 0.5, 0.1}, 1, {0, 0, 0.1}, way * 2);
    plan_scenes::box(scene, {0.3, 0.3, 0.1}, load, {0, 0, 0.3}, way * 2);
    const auto run = run_of(scene);
    run->advance(0.6);
    for (std::size_t i = 1; i <= 2; ++i) {
      CAPTURE(load, i);
      const Point moved = run->position(i) - scene.bodies[i].position;
      // 2²/(2 μ g), in thirty steps; a light one below is held by as much as it is drawn.
      CHECK(std::abs(moved.dot(way) - 0.5) < (i == 2 ? 1e-7 : 1e-3));
      CHECK((moved - way * moved.dot(way)).norm() < 1e-7);
      CHECK(run->velocity(i).norm() < 1e-6);
    }
  }
}

TEST_CASE("a body that falls along a wall falls as if nothing divided its steps") {
  for (const int balls : {0, 1, 2, 3}) {
    CAPTURE(balls);
    Scene scene = with_gravity(0, 0, 1.0 / 60, 1e-4);
    plan_scenes::wall(scene, Point::UnitY(), 0);
    plan_scenes::wall(scene, Point::UnitZ(), 0);
    // It lies along the wall, one end touches it, and the other approaches it over a millimetre.
    const double angle = std::asin(1e-3 / 0.4);
    auto& capsule =
        plan_scenes::add(scene, contact::CapsuleShape{0.05, 0.2}, 1, {0, 0.0505, 3}, {0, -0.2, 0});
    capsule.orientation = contact::exponential<double>(Point(0, 0, angle)) *
                          contact::exponential<double>(Point(0, std::acos(-1.0) / 2, 0));
    capsule.angular_velocity = {0, 0, -1};
    for (int k = 0; k < balls; ++k)
      plan_scenes::ball(scene, 0.05, 1, {2.0 + k, 1, 0.055 + 0.005 * k}, {0, 0, -5});
    const auto run = run_of(scene);
    run->advance(1.0 / 60);
    CHECK(std::abs(run->velocity(2).z() + 10.0 / 60) < 1e-12);
    CHECK(std::abs(run->position(2).z() - (3 - 5.0 / 3600)) < 1e-12);
  }
}

TEST_CASE("an elastic ball rebounds from a box under a heavy load") {
  for (const double load : {1.0, 1e4, 1e6}) {
    CAPTURE(load);
    Scene scene = with_gravity(1, 0, 0.4, 1e-3);
    plan_scenes::wall(scene, Point::UnitZ(), 0);
    plan_scenes::box(scene, {1, 0.5, 0.5}, 1, {0, 0, 0.5});
    plan_scenes::box(scene, {0.5, 0.5, 0.5}, load, {-0.2, 0, 1.5});
    plan_scenes::ball(scene, 0.1, 1e-3, {0.8, 0, 1.3});
    const auto run = run_of(scene);
    run->advance(0.4);  // it falls by 0.2 m in 0.2 s, and is back
    CHECK(run->counts().hits > 0);
    CHECK(std::abs(run->position(3).z() - 1.3) < 1e-3);
  }
}

TEST_CASE("a plate that leaves another with a vertex beyond its edge does not fall through it") {
  Scene scene = with_gravity(0, 0.5, 0.1, 1e-4);
  plan_scenes::box(scene, {0.5, 0.5, 0.0005}, 0, {0, 0, -0.0005});
  auto& plate = plan_scenes::box(scene, {0.25, 0.25, 0.0005}, 1, {0.4, 0, 0.0005}, {0, 0, 0.001});
  plate.angular_velocity = {0, 0.006, 0};
  const auto run = run_of(scene);
  run->advance(0.1);
  CHECK(std::abs(run->position(1).z() - 0.0005) < 1e-5);
  CHECK(run->counts().largest_overlap < 5e-5);
}

TEST_CASE("contacts are solved together exactly where moving bodies connect them") {
  Random random(31);
  for (int round = 0; round < generators::tried(500); ++round) {
    contact::SteppedSetup setup;
    contact::SteppedState state;
    const int count = random.integer(2, 12);
    setup.bodies.resize(static_cast<std::size_t>(count));
    setup.movers = static_cast<std::size_t>(random.integer(1, count));
    state.sleeps_with.assign(setup.movers, -1);
    for (int& with : state.sleeps_with) with = random.chance(0.1) ? 0 : -1;
    std::vector<contact::BodyContact<double>> contacts(
        static_cast<std::size_t>(random.integer(0, 14)));
    for (auto& one : contacts) {
      one.a = random.integer(0, count - 1);
      one.b = random.integer(0, count - 1);
    }
    // Linked by one body, then by links of links until nothing changes.
    const std::size_t n = contacts.size();
    std::vector<std::vector<bool>> linked(n, std::vector<bool>(n));
    const auto moves = [&](int body) {
      const auto place = static_cast<std::size_t>(body);
      return place < setup.movers && state.sleeps_with[place] < 0;
    };
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        for (const int body : {contacts[i].a, contacts[i].b})
          if (i == j || (moves(body) && (body == contacts[j].a || body == contacts[j].b)))
            linked[i][j] = true;
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
          if (linked[i][k] && linked[k][j]) linked[i][j] = true;
    std::vector<int> island(n, -1);
    const auto found = contact::detail::islands(setup, state, contacts);
    for (std::size_t k = 0; k < found.size(); ++k)
      for (const std::size_t i : found[k]) {
        REQUIRE(island[i] == -1);
        island[i] = static_cast<int>(k);
      }
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) REQUIRE((island[i] == island[j]) == linked[i][j]);
  }
}
