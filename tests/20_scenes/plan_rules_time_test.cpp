// Every rule of cost, precision and time, at its edge: a scene in which one condition of a proof
// fails, and no other. The plan must keep the effect; the rule with that one condition weakened
// would leave it out; and an exact argument or a plain simulation shows that the answer would be
// wrong then. With each comes a scene on the other side of the edge, where the effect is off by
// proof.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/bouncing.hpp>
#include <contact/events/hard_sphere_compose.hpp>
#include <contact/events/hard_sphere_scene.hpp>
#include <contact/plan/plan.hpp>
#include <contact/plan/plan_costs.hpp>
#include <string>

#include "plan_at_edge.hpp"
#include "plan_scenes.hpp"
#include "support/oracle.hpp"

using contact::Decision;
using contact::Effect;
using contact::Scene;
using oracle::exact;
using plan_scenes::at_edge;
using plan_scenes::ball;
using plan_scenes::box;
using plan_scenes::crowd;
using plan_scenes::dropped;
using plan_scenes::empty;
using plan_scenes::free_ball;
using plan_scenes::least;
using plan_scenes::off;
using plan_scenes::Point;
using plan_scenes::wall;

TEST_CASE("the broad phase is a question of cost: few bodies do without, many do not") {
  const auto spread = [](int n, double back = -3) {
    Scene scene = empty(1, 0, 1, 1e-6);
    for (int i = 0; i < n; ++i)
      ball(scene, 0.5, 1, {2.0 * (i % 8), 2.0 * (i / 8 % 8), 2.0 * (i / 64)},
           {i % 2 == 0 ? 3 : back, 0.2, 0.3});
    return scene;
  };
  off(spread(1), Effect::broad_phase);
  off(spread(4), Effect::broad_phase);
  at_edge(spread(200), Effect::broad_phase, 0, 0);
  // From event to event the run tests all pairs as long as the plan says so.
  const auto most = static_cast<int>(contact::cost::max_balls_without_cells);
  off(spread(most), Effect::broad_phase);
  at_edge(spread(most + 1), Effect::broad_phase, 0, 0);
  for (const int n : {most, most + 1}) {
    const auto setup = contact::hard_sphere_setup(spread(n)).setup;
    CHECK(contact::compose_hard_spheres(setup).effects.grid == (n > most));
  }
  // In steps it is a question of comparisons: all of them are n (n - 1)/2.
  contact::PlanOptions steps;
  steps.step = 0.01;
  const Decision four =
      contact::decision_on(contact::plan_scene(spread(4), steps), Effect::broad_phase);
  CHECK_FALSE(four.on);
  CHECK(four.because.at(0).left == contact::cost::box_test * 6);
  CHECK(contact::decision_on(contact::plan_scene(spread(200), steps), Effect::broad_phase).on);
  // All of them fly alike, so no two meet.
  const Decision alike = plan_scenes::decision(spread(200, 3), Effect::broad_phase);
  CHECK_FALSE(alike.on);
  CHECK(alike.because.at(0).left == 0);
}

TEST_CASE("float: not where the square of a time overflows") {
  Scene endless = free_ball(0, 1e20, 1e-3);
  endless.bodies[0].velocity.setZero();
  CHECK(plan_scenes::is_on(endless, Effect::double_precision));
  CHECK(plan_scenes::is_on(free_ball(1e30, 1e-29, 1e-27), Effect::double_precision));
  CHECK(plan_scenes::is_on(free_ball(0, 1, 1e-25), Effect::double_precision));
}

TEST_CASE("the horizon: off only where nothing spreads") {
  Scene floor = empty(1, 0, 30, 1e-6);
  floor.gravity = {0, 0, -10};
  plan_scenes::wall(floor, {0, 0, 1}, 0);
  ball(floor, 0.25, 2, {0, 0, 1});
  off(floor, Effect::horizon);
  Scene column = floor;
  ball(column, 0.25, 1, {0, 0, 2.5});
  CHECK(plan_scenes::is_on(column, Effect::horizon));
  column.gravity.setZero();
  column.bodies[1].velocity = {0, 0, 1};
  // A hit of the two may be at the same instant as one on the floor, and the order decides, unless
  // the masses are equal and exchange their velocities.
  CHECK(plan_scenes::is_on(column, Effect::horizon));
  column.bodies[1].mass = 1;
  off(column, Effect::horizon);
  Scene upright = floor;
  plan_scenes::wall(upright, {1, 0, 0}, -5);
  upright.bodies[1].velocity = {1, 0, 0};
  off(upright, Effect::horizon);
  Scene rubbing = upright;
  rubbing.materials[0].friction = 0.5;
  CHECK(plan_scenes::is_on(rubbing, Effect::horizon));
  Scene wedge = floor;
  wedge.bodies[0].shape = contact::HalfSpaceShape{{0.6, 0, 0.8}, 0};
  wedge.bodies[1].position = {0, 0, 3};
  off(wedge, Effect::horizon);
  plan_scenes::wall(wedge, {-0.6, 0, 0.8}, 0);
  CHECK(plan_scenes::is_on(wedge, Effect::horizon));
  Scene die = floor;
  plan_scenes::box(die, {0.2, 0.25, 0.3}, 1, {5, 0, 1}).angular_velocity = {1, 2, 3};
  const contact::Plan plan = contact::plan_scene(die);
  CHECK(contact::decision_on(plan, Effect::horizon).on);
  CHECK_FALSE(contact::decision_on(plan, Effect::horizon).value);
  bool told = false;
  for (const std::string& notice : plan.notices)
    told = told || notice.find("is not known") != std::string::npos;
  CHECK(told);
}

TEST_CASE("the horizon: a light body is fast, however heavy the others are") {
  Scene gas = empty(1, 0, 1000, 1e-6);
  plan_scenes::walls(gas, {8, 8, 8});
  for (int i = 0; i < 8; ++i)
    ball(gas, 0.5, 1, {1.0 + 1.5 * (i % 3), 1.0 + 1.5 * (i / 3), 4}, {1, 0.5 * i, 0.25});
  const auto horizon = [](const Scene& scene) {  // from the first hit on
    const Decision decision = contact::decision_on(contact::plan_scene(scene), Effect::horizon);
    return *decision.value - decision.because[0].right;
  };
  ball(gas, 0.5, 1, {6, 6, 6});
  const double before = horizon(gas);
  gas.bodies.back().mass = 1e6;
  CHECK(horizon(gas) <= before);  // a heavy body at rest slows none
  gas.bodies.back().velocity = {1, 0, 0};
  CHECK(horizon(gas) <= before / 50);
}

TEST_CASE("the horizon: errors grow from the earliest possible first hit") {
  const auto horizon = [](const Scene& scene) {
    return contact::decision_on(contact::plan_scene(scene), Effect::horizon);
  };
  const auto first = [&](const Scene& scene) { return horizon(scene).because[0].right; };
  Scene near = empty(1, 0, 1000, 1e-6);
  plan_scenes::walls(near, {500, 500, 500});
  ball(near, 0.5, 1, {300, 100, 100}, {2, 0, 0});
  ball(near, 0.5, 1, {311, 100, 100});
  CHECK(std::abs(first(near) - 5) < 1e-12);
  CHECK(*horizon(near).value > 5);
  // Both move: their speed of approach counts. A nearer wall is hit first.
  near.bodies.back().velocity = {-3, 0, 0};
  CHECK(std::abs(first(near) - 2) < 1e-12);
  near.bodies.back().velocity = {4, 0, 0};
  CHECK(std::abs(first(near) - 188.5 / 4) < 1e-12);  // they separate, and the far wall is next
  ball(near, 0.5, 1, {100, 1.5, 400}, {0, -1, 0});
  CHECK(std::abs(first(near) - 1) < 1e-12);
  // Gravity does not bring falling bodies together, but all of them to fixed ones.
  near.gravity = {0, 0, -10};
  ball(near, 0.5, 1, {400, 400, 0.5 + 0.05});
  CHECK(std::abs(first(near) - 0.1) < 1e-9);
  // Touching bodies may hit at once.
  ball(near, 0.5, 1, {401, 400, 0.5 + 0.05}, {-1, 0, 0});
  CHECK(first(near) == 0);
}

TEST_CASE("the horizon: a crowd is one, however far away another body is") {
  Scene crowd = empty(1, 0, 1000, 1e-6);
  plan_scenes::walls(crowd, {400, 400, 400});
  for (int i = 0; i < 27; ++i)
    ball(crowd, 0.5, 1, {10 + 1.5 * (i % 3), 10 + 1.5 * (i / 3 % 3), 10 + 1.5 * (i / 9)},
         {1, 0.1 * i, 0.25});
  const auto horizon = [](const Scene& scene) {
    return contact::decision_on(contact::plan_scene(scene), Effect::horizon).value.value();
  };
  const double before = horizon(crowd);
  ball(crowd, 0.5, 1, {390, 390, 390});
  CHECK(horizon(crowd) <= 2 * before);
}

TEST_CASE("the step: a crowd's hits are late, even with continuous detection") {
  for (const int count : {64, 65}) {
    CAPTURE(count);
    Scene scene = empty(1, 0, 2, 1);
    plan_scenes::wall(scene, {1, 0, 0}, -10);
    for (int k = 0; k < count; ++k) ball(scene, 0.1, 1, {0, 100.0 * k, 0}, {-6, 0, 0});
    contact::PlanOptions options;
    options.overrides.without = {Effect::event_driven};
    options.overrides.with = {Effect::continuous_detection};
    const contact::Plan plan = contact::plan_scene(scene, options);
    const Decision& step = contact::decision_on(plan, Effect::step_size);
    // Each hits once, at 6 m/s, and its error is the distance that it flies too far to the wall and
    // back.
    CHECK(step.error == (count > 64 ? plan.error : 0));
    if (count > 64) {
      CHECK(step.error >= 2 * 6 * plan.step);
      CHECK(step.error <= 1);
      CHECK_FALSE(step.proven);
    }
  }
}

TEST_CASE("float: enough for a short flight, not for a position that it cannot represent") {
  const Scene near = free_ball(8, 1, 1e-3);
  off(near, Effect::double_precision);
  const auto& body = near.bodies[0];
  const float z = static_cast<float>(body.position.z()) +
                  1.0F * (static_cast<float>(body.velocity.z()) + 1.0F * -8.0F / 2);
  CHECK(std::abs(static_cast<double>(z) + 4) <= 1e-3);

  Scene far = free_ball(0, 1, 0.5);
  far.bodies[0].position.x() = 16777217;
  at_edge(far, Effect::double_precision, 0, 1);
  CHECK(exact(static_cast<double>(static_cast<float>(16777217.0))) - exact(16777217.0) == -1);
  at_edge(dropped(1, 2, 3, 1), Effect::double_precision, 0, 0);
}

TEST_CASE("from event to event: only if the events are bounded") {
  off(dropped(1, 2, 60), Effect::event_driven);  // proven, and so on
  const auto bounces = contact::bouncing_ball<double>(2, 0, 8, 0.5);
  const double rest = contact::rest_time(bounces);
  off(dropped(0.5, 2, 0.9 * rest, 0), Effect::event_driven);
  // Beyond the last bounce there are infinitely many; only bounces below a tolerance may be left
  // out.
  const Scene zeno = dropped(0.5, 2, 10, 0);
  at_edge(zeno, Effect::event_driven, 1, 5);
  CHECK(std::isinf(contact::bounce_at<double>(bounces, 10).bounces));
  const Decision short_bounces =
      plan_scenes::decision(dropped(0.5, 2, 10, 1e-6), Effect::event_driven);
  CHECK(short_bounces.on);
  CHECK(short_bounces.error > 0);
  CHECK(short_bounces.error <= 1e-6);

  Scene rough = dropped(1, 2, 60);
  rough.bodies[1].velocity.x() = 1;
  rough.materials[0].friction = least;
  at_edge(rough, Effect::event_driven, 0, 3);
  Scene soft = dropped(1, 2, 60);
  soft.materials[0].stiffness = 1e6;
  CHECK_FALSE(plan_scenes::is_on(soft, Effect::event_driven));
  Scene gas = empty(0.9, 0, 10, 1e-6);
  plan_scenes::walls(gas, {4, 4, 4});
  ball(gas, 0.5, 1, {1, 1, 1}, {1, 2, 3});
  ball(gas, 0.5, 1, {3, 3, 3});
  CHECK_FALSE(plan_scenes::is_on(gas, Effect::event_driven));
  gas.materials[0].restitution = 1;
  off(gas, Effect::event_driven);
}

TEST_CASE("the step follows from the tolerance, and a hit that is late by it stays within") {
  Scene scene = dropped(1, 2, 1.5, 1e-3);
  scene.materials[0].friction = 0.5;
  scene.bodies[1].velocity.x() = 1;  // friction: step by step
  const contact::Plan plan = contact::plan_scene(scene);
  CHECK_FALSE(contact::decision_on(plan, Effect::event_driven).on);
  const Decision& step = contact::decision_on(plan, Effect::step_size);
  REQUIRE(step.value);
  CHECK(step.proven);
  // One hit: (1 + e)(v + μ g T) h, with v at least √(2 g h) = √32 and at most √33.
  CHECK(2 * (std::sqrt(32.0) + 6) * *step.value <= 1e-3);
  CHECK(2 * (std::sqrt(34.0) + 6) * *step.value >= 1e-3 / 2);
  CHECK_FALSE(contact::decision_on(plan, Effect::continuous_detection).on);
  // Where that would be a thousandth of a frame, impacts are found between frames.
  scene.tolerance.position = 1e-6;
  CHECK(contact::plan_scene(scene).step == 1.0 / 60);
  CHECK(plan_scenes::is_on(scene, Effect::continuous_detection));
}

TEST_CASE("the horizon: flat walls have none, balls have one that a tolerance can outlive") {
  off(dropped(1, 2, 1e6), Effect::horizon);
  Scene gas = empty(1, 0, 1000, 1e-3);
  plan_scenes::walls(gas, {8, 8, 8});
  for (int i = 0; i < 10; ++i)
    ball(gas, 0.5, 1, {1.0 + 1.5 * (i % 3), 1.0 + 1.5 * (i / 3), 4}, {1, 0.5 * i, 0.25});
  const contact::Plan plan = contact::plan_scene(gas);
  const Decision& horizon = contact::decision_on(plan, Effect::horizon);
  REQUIRE(horizon.value);
  CHECK(*horizon.value > 0);
  CHECK(*horizon.value < 1000);
  REQUIRE_FALSE(plan.notices.empty());
  CHECK(plan.notices[0].find("only conserved quantities and statistics") != std::string::npos);
  gas.duration = *horizon.value / 2;
  for (const std::string& notice : contact::plan_scene(gas).notices)
    CHECK(notice.find("only conserved quantities and statistics") == std::string::npos);
}

TEST_CASE("from event to event: fixed bodies are half-spaces or balls") {
  Scene scene = empty(1, 0, 2, 1e-6);
  ball(scene, 0.5, 1, {0, 0, 0}, {2, 0.25, 0});
  box(scene, {0.5, 2, 0.75}, 0, {2, 0, 0.5});
  at_edge(scene, Effect::event_driven, 0, 1);
}

TEST_CASE("from event to event: only motions that have a formula between events") {
  // Without gravity, and elastic: a box that meets a wall.
  Scene corners = empty(1, 0, 10, 1e-6);
  wall(corners, Point::UnitX(), -2);
  box(corners, {0.5, 0.5, 0.5}, 1, Point::Zero(), {-1, 0, 0});
  at_edge(corners, Effect::event_driven, 0, 0);
  // A box that tumbles and meets nothing.
  Scene tumbling = empty(1, 0, 2, 1e-6);
  box(tumbling, {1, 2, 3}, 1, Point::Zero()).angular_velocity = {1, 2, 3};
  at_edge(tumbling, Effect::event_driven, 0, 4);
}
