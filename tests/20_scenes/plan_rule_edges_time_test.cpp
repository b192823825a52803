// The edges of rules that plan_rules_*_test.cpp leave, of time, precision and the horizon: each
// scene was made for one condition, one term or one order of a rule, so that a rule without it, or
// with another in its place, gives a wrong answer.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/plan/plan.hpp>
#include <contact/plan/plan_rules.hpp>
#include <contact/quaternion.hpp>
#include <contact/scene/scene_solids.hpp>
#include <utility>

#include "plan_at_edge.hpp"
#include "plan_scenes.hpp"
#include "support/generators.hpp"

using contact::Decision;
using contact::Effect;
using contact::Scene;
using generators::Random;
using generators::tried;
using plan_scenes::at_edge;
using plan_scenes::ball;
using plan_scenes::box;
using plan_scenes::decision;
using plan_scenes::dropped;
using plan_scenes::empty;
using plan_scenes::free_ball;
using plan_scenes::is_on;
using plan_scenes::off;
using plan_scenes::Point;
using plan_scenes::stepped;
using plan_scenes::wall;

TEST_CASE(
    "from event to event: a ball that touches another at the start passes a hit on, unless it is "
    "alone") {
  // Two hits at one instant: their order decides.
  Scene row = empty(1, 0, 3, 0);
  ball(row, 0.5, 1, {-2, 0, 0}, {1, 0, 0});
  ball(row, 0.5, 2, Point::Zero());
  ball(row, 0.5, 4, {1, 0, 0});
  at_edge(row, Effect::event_driven, 0, 6);
  row.bodies.pop_back();
  off(row, Effect::event_driven);
}

TEST_CASE("float: only numbers whose squares it holds, and all of its digits") {
  Scene endless = empty(1, 0, 1e-15, 1e-3);
  endless.gravity = {0, 0, -1e19};
  ball(endless, 0.5, 1, Point::Zero());
  at_edge(endless, Effect::double_precision, 0, 3);
  Scene whirling = empty(1, 0, 1e-22, 1e-3);
  box(whirling, {1, 1, 1}, 1, Point::Zero()).angular_velocity = {0, 0, 1e19};
  at_edge(whirling, Effect::double_precision, 0, 3);
  Scene tiny = empty(1, 0, 1, 0x1p-81);
  ball(tiny, 0.5, 1, Point::Zero(), {1e-38, 0, 0});
  at_edge(tiny, Effect::double_precision, 0, 3);
  // Ten thousand kilometres of motion, of fall and of rotation, each by itself: floats there are a
  // metre apart.
  Scene far = free_ball(0, 1, 0.3);
  far.bodies[0].velocity = {1e7 + 1, 0, 0};
  at_edge(far, Effect::double_precision, 0, 1);
  Scene deep = free_ball(2e7, 1, 0.3);
  at_edge(deep, Effect::double_precision, 0, 1);
  Scene wide = empty(1, 0, 1, 0.3);
  box(wide, Point::Constant(1e7), 1, Point::Zero()).angular_velocity = {0, 0, 1e-3};
  ball(wide, 0.5, 1, {0, 0, 4e7});
  at_edge(wide, Effect::double_precision, 0, 1);
  Scene often = empty(1, 0, 1, 1e-3);
  box(often, {1, 1, 1}, 1, Point::Zero()).angular_velocity = {0, 0, 1e5};
  ball(often, 0.5, 1, {0, 0, 4});
  at_edge(often, Effect::double_precision, 0, 1);
  box(often, {1, 1, 1}, 1, {0, 0, 8}).angular_velocity = {0, 0, 1e-3};
  at_edge(often, Effect::double_precision, 0, 1);
}

TEST_CASE("float: the errors of a flight and a rotation are below the bound, but not far below") {
  Random random(45);
  constexpr double u = 0x1p-24;
  double most = 0;
  double max_turned = 0;
  for (int trial = 0; trial < tried(4000); ++trial) {
    const double x = random.uniform(-1, 1);
    const double v = random.uniform(1, 2);
    const double t = random.uniform(1, 2);
    const float as_float = static_cast<float>(x) + static_cast<float>(v) * static_cast<float>(t);
    const double size = std::abs(x) + v * t;
    most = std::max(most, std::abs(static_cast<double>(as_float) - (x + v * t)) / (u * size));
    const double fast = random.uniform(1, 20);
    const Point angular_velocity = fast * Point(random.uniform(), 0.5, 0.25).normalized();
    const contact::Vector3<float> half_turned =
        (angular_velocity.cast<float>() * static_cast<float>(t));
    const auto turned = contact::matrix_of(contact::exponential<float>(half_turned));
    const auto right = contact::matrix_of(contact::exponential<double>(angular_velocity * t));
    const Point corner = Point(1, 1, 1).normalized();
    const Point aside = (turned * corner.cast<float>()).cast<double>() - right * corner;
    max_turned = std::max(max_turned, aside.norm() / (u * (1 + fast * t)));
  }
  CAPTURE(most, max_turned);
  CHECK(most <= 16);
  CHECK(most > 2);
  CHECK(max_turned <= 32);
  // The rule's bounds on both: 16 and 32 of these.
  Scene moved = free_ball(0, 1.5, 1);
  moved.bodies[0].velocity = {3, 0, 0};
  CHECK(decision(moved, Effect::double_precision).tried.at(0).conditions.at(1).left >=
        most * u * 4.5);
}

TEST_CASE("the step: no longer than the output interval, nor proven if a hit may be missed") {
  Scene scene = dropped(1, 2, 1.5, 1e-3);
  scene.materials[0].friction = 0.5;
  scene.bodies[1].velocity.x() = 1;
  scene.tolerance.position = 1e-9;
  CHECK(contact::plan_scene(scene).step == 1.0 / 60);
  scene.output.every = 0x1p-8;
  CHECK(contact::plan_scene(scene).step == 0x1p-8);
  // A crowd whose late hits exceed the error budget.
  Scene crowd = empty(1, 0, 2, 1e-3);
  wall(crowd, {1, 0, 0}, -10);
  for (int k = 0; k < 65; ++k) ball(crowd, 0.1, 1, {0, 100.0 * k, 0}, {-6, 0, 0});
  contact::PlanOptions options = stepped(1.0 / 60);
  options.overrides.with = {Effect::continuous_detection};
  CHECK(std::isinf(decision(crowd, Effect::step_size, options).error));
  CHECK(std::isinf(contact::plan_scene(crowd, options).error));
}

TEST_CASE("the horizon: a die on a floor, and balls that a spring throws up") {
  Scene die = dropped(1, 1, 30);
  die.bodies[1].shape = contact::BoxShape{{0.2, 0.25, 0.3}};
  die.bodies[1].inertia = contact::solid_inertia(die.bodies[1].shape, 1);
  die.bodies[1].angular_velocity = {1, 2, 3};
  at_edge(die, Effect::horizon, 0, 1);
  Scene column = dropped(0, 1, 30);
  ball(column, 0.5, 2, {0, 0, 3});
  off(column, Effect::horizon);  // no rebound
  column.materials[0].stiffness = 1000;
  CHECK(is_on(column, Effect::horizon));
  // Two that fall and bounce on one line, of which one alone would be known.
  Scene two = dropped(1, 1, 30);
  off(two, Effect::horizon);
  ball(two, 0.5, 2, {0, 0, 3});
  CHECK(is_on(two, Effect::horizon));
}

TEST_CASE("the horizon does not depend on the order of names") {
  // Different in everything, among posts, falling.
  for (const auto& [g, tolerance] :
       {std::pair(0.0, 1e-6), std::pair(2.0, 1e-6), std::pair(0.0, 0.0)}) {
    Scene scene = empty(1, 0, 1000, tolerance);
    scene.gravity = {0, 0, -g};
    plan_scenes::walls(scene, {12, 12, 12});
    ball(scene, 0.3, 1, {2, 2, 2}, {1, 2, 0});
    ball(scene, 0.2, 0.25, {5, 2, 3}, {0, 0.5, 0.25});
    ball(scene, 0.5, 4, {2, 6, 9}, {0.25, 0, 0.5});
    ball(scene, 0.4, 2, {9, 9, 4});
    for (const Point& at : {Point(4, 4, 4), Point(8, 4, 4), Point(4, 8, 4), Point(4, 4, 8)})
      ball(scene, 0.25, 0, at);
    const auto horizon = [&] { return decision(scene, Effect::horizon).value.value(); };
    const double right = horizon();
    for (std::size_t k = 1; k < scene.bodies.size(); ++k) {
      std::rotate(scene.bodies.begin(), scene.bodies.begin() + 1, scene.bodies.end());
      CHECK(std::abs(horizon() / right - 1) < 1e-12);
    }
  }
}

TEST_CASE("the horizon: the fastest body decides, by its speed or by the energy that it may get") {
  const auto pace = [](const Scene& scene) {  // from the first hit on
    const Decision made = decision(scene, Effect::horizon);
    return *made.value - made.because[0].right;
  };
  const auto gas = [](double others) {
    Scene scene = empty(1, 0, 1000, 1e-6);
    plan_scenes::walls(scene, {12, 12, 12});
    for (int k = 0; k < 8; ++k)
      ball(scene, 0.5, 1, {2.0 + 4 * (k % 2), 2.0 + 4 * (k / 2 % 2), 2.0 + 4 * (k / 4)},
           {k == 3 ? 3 : others, 0, 0});
    return scene;
  };
  CHECK(std::abs(pace(gas(0)) / pace(gas(3)) - 1) < 1e-12);
  // A body that starts at rest and falls has a rate of hits as well.
  Scene falls = gas(0);
  falls.bodies[9].velocity.setZero();
  falls.gravity = {0, 0, -8};
  CHECK(decision(falls, Effect::horizon).value.has_value());
  // A hit of two balls is spread by other hits of theirs: sooner than that of one among posts.
  Scene alone = gas(0);
  for (std::size_t k = 6; k < alone.bodies.size(); ++k)
    if (k != 9) alone.bodies[k].moves = false;
  CHECK(pace(alone) > pace(gas(0)));
  // A large post among them makes no ball larger, and far away an ulp is larger.
  Scene post = gas(3);
  ball(post, 2, 0, {9.5, 9.5, 9.5});
  CHECK(pace(post) <= pace(gas(3)) * (1 + 1e-12));
  Scene away = gas(3);
  for (auto& body : away.bodies) {
    body.position.x() += 1e6;
    if (auto* side = std::get_if<contact::HalfSpaceShape>(&body.shape))
      side->offset += 1e6 * side->normal.x();
  }
  CHECK(pace(away) < pace(gas(3)));
  // Less tolerance is passed sooner, and gravity makes no horizon longer.
  Scene strict = gas(3);
  strict.tolerance.position = 1e-9;
  CHECK(pace(strict) < pace(gas(3)));
  Scene pulled = gas(3);
  pulled.gravity = {0, 0, -0.01};
  CHECK(pace(pulled) < pace(gas(3)));
}

TEST_CASE("the horizon: a rotating body may touch as early as its vertices arrive") {
  // A rod that rotates at 1 rad/s, 2.02 m long to each side, its centre one metre above a floor.
  const auto first = [](double angular_velocity, bool both) {
    Scene scene = empty(1, 0, 1000, 1e-6);
    plan_scenes::add(scene, contact::CapsuleShape{0.25, 2}, 1, {0, 0, 1}, {0, 0, -0.125})
        .angular_velocity = {angular_velocity, 0, 0};
    if (both) {
      plan_scenes::add(scene, contact::CapsuleShape{0.25, 2}, 1, {0, 6, 1}, {0, -1, 0})
          .angular_velocity = {angular_velocity, 0, 0};
    } else {
      wall(scene, Point::UnitZ(), -9);
    }
    return contact::detail::first_touch(contact::plan_input(scene));
  };
  // Surfaces move at 2.25 m/s and more.
  for (const bool both : {false, true}) {
    CAPTURE(both);
    const double still = first(0, both);
    CHECK(first(1, both) < still / 1.5);
    CHECK(first(-2, both) <= first(1, both));
  }
  CHECK(first(1, true) <= 5.5 / (1 + 2 * 2.25) * (1 + 1e-9));
  // A body at rest above a fixed ball falls on it after a second.
  Scene over = empty(1, 0, 1000, 1e-6);
  over.gravity = {0, 0, -10};
  ball(over, 0.5, 0, Point::Zero());
  ball(over, 0.5, 1, {0, 0, 6});
  CHECK(contact::detail::first_touch(contact::plan_input(over)) <= 1 + 1e-9);
}

TEST_CASE("the horizon: between two slopes an error grows e times in a third of the time v/g") {
  // It falls from rest, by less than 3 m to either of them.
  const auto known = [](double tolerance) {
    Scene scene = empty(1, 0, 1000, tolerance);
    scene.gravity = {0, 0, -8};
    wall(scene, {0.6, 0, 0.8}, 0);
    wall(scene, {-0.6, 0, 0.8}, 0);
    ball(scene, 0.5, 1, {0.1, 0, 3});
    return decision(scene, Effect::horizon).value.value();
  };
  const double longer = known(1e-3) - known(1e-6);
  CHECK(longer > 0);
  CHECK(longer <= std::log(1000) * std::sqrt(2 * 8 * 3.0) / (3 * 8) * (1 + 1e-9));
}
