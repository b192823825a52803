// Every rule of contacts, at its edge: a scene in which one condition of a proof fails, and no
// other. The plan must keep the effect; the rule with that one condition weakened would leave it
// out; and an exact argument or a plain simulation shows that the answer would be wrong then. With
// each comes a scene on the other side of the edge, where the effect is off by proof.
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/bouncing.hpp>
#include <contact/plan/plan.hpp>
#include <contact/plan/plan_bounds.hpp>
#include <contact/plan/plan_costs.hpp>
#include <contact/scene/scene_runs.hpp>
#include <string>

#include "plan_at_edge.hpp"
#include "plan_scenes.hpp"
#include "support/oracle.hpp"

using contact::Decision;
using contact::Effect;
using contact::Scene;
using oracle::exact;
using oracle::Rational;
using plan_scenes::at_edge;
using plan_scenes::ball;
using plan_scenes::box;
using plan_scenes::dropped;
using plan_scenes::empty;
using plan_scenes::free_ball;
using plan_scenes::least;
using plan_scenes::off;
using plan_scenes::Point;
using plan_scenes::wall;

TEST_CASE("friction: however small, it slows a sliding body") {
  Scene sliding = dropped(0.5, 2, 3);
  sliding.bodies[1].velocity.x() = 1;
  off(sliding, Effect::friction);
  sliding.materials[0].friction = least;
  at_edge(sliding, Effect::friction, 0, 0);
  CHECK(exact(least) > 0);  // times (1 + e) v of the hit: not 0 without rounding
}

TEST_CASE("restitution: off only if nothing rebounds") {
  off(dropped(0, 2, 3), Effect::restitution);
  at_edge(dropped(0x1p-60, 2, 3), Effect::restitution, 0, 0);
  CHECK(exact(0x1p-60) * 4 > 0);  // the speed after a hit at 4 m/s
  off(free_ball(8, 1, 1e-9), Effect::restitution);
}

TEST_CASE("penalty contact: off if no contact that may occur is compliant") {
  off(dropped(0.5, 2, 3), Effect::penalty_contact);
  Scene soft = dropped(0.5, 2, 3);
  soft.materials.push_back({"felt", 0.5, 0, 1e4, 1});
  off(soft, Effect::penalty_contact);  // no body is made of it
  soft.bodies[1].material = 1;
  at_edge(soft, Effect::penalty_contact, 0, 0);
  soft.duration = 0.001;  // the floor is out of reach
  off(soft, Effect::penalty_contact);
}

TEST_CASE("several contacts: two partners, or a face") {
  off(dropped(0.5, 2, 3), Effect::several_contacts);
  Scene row = empty(0.5, 0, 3, 1e-6);
  ball(row, 0.5, 1, {-2, 0, 0}, {1, 0, 0});
  ball(row, 0.5, 2, Point::Zero());
  ball(row, 0.5, 4, {2, 0, 0}, {-1, 0, 0});
  at_edge(row, Effect::several_contacts, 0, 0);
  // Both hit at t = 1. One after the other, the order decides the velocities after them: exactly.
  const auto hit = [](Rational& u, Rational& v, const Rational& m, const Rational& n) {
    const Rational impulse = Rational(3) / 2 * (u - v) / (1 / m + 1 / n);
    u -= impulse / m;
    v += impulse / n;
  };
  std::array<Rational, 3> first{1, 0, -1};
  hit(first[0], first[1], 1, 2);
  hit(first[1], first[2], 2, 4);
  std::array<Rational, 3> second{1, 0, -1};
  hit(second[1], second[2], 2, 4);
  hit(second[0], second[1], 1, 2);
  CHECK(first[0] != second[0]);
  CHECK(first[2] != second[2]);

  Scene face = empty(0.5, 0, 3, 1e-6);
  face.gravity = {0, 0, -8};
  wall(face, Point::UnitZ(), 0);
  box(face, {1, 1, 1}, 1, {0, 0, 3});
  at_edge(face, Effect::several_contacts, 0, 1);  // four vertices land at once
}

TEST_CASE("resting: a ball that starts on the floor, and one that starts one ulp above it") {
  // With friction, or the floor would be a level table that cancels gravity.
  Scene lying = dropped(1, 0, 3);
  lying.materials[0].friction = 0.25;
  at_edge(lying, Effect::resting, 2, 2);
  Scene above = lying;
  above.bodies[1].position.z() = std::nextafter(0.5, 1);
  off(above, Effect::resting);
  Scene thrown = lying;
  thrown.bodies[1].velocity.z() = 1;
  off(thrown, Effect::resting);
  // The same without a force that presses.
  Scene weightless = lying;
  weightless.gravity = Point::Zero();
  off(weightless, Effect::resting);
  Scene hardly = dropped(0.5, 0, 3);
  hardly.gravity.z() = -least;
  hardly.materials[0].friction = 0.25;
  at_edge(hardly, Effect::resting, 0, 0);
}

TEST_CASE("resting: until the last bounce of a ball, by its closed form") {
  for (const double e : {0.25, 0.5, 0.9, 0.99}) {
    const auto closed = contact::bouncing_ball<double>(2, 0, 8, e);
    const double rest = contact::rest_time(closed);
    const Scene after = dropped(e, 2, rest);
    at_edge(after, Effect::resting, 3, 0);
    off(dropped(e, 2, rest * (1 - 1e-9)), Effect::resting);
    CHECK(contact::bounce_at(closed, rest * (1 + 1e-9)).resting);
  }
  // With a second ball in reach nothing is proven; alone the lower one rests well within 100 s.
  Scene two = dropped(0.5, 2, 100);
  ball(two, 0.5, 1, {0, 0, 50});
  at_edge(two, Effect::resting, 2, 0);
  CHECK(contact::rest_time(contact::bouncing_ball<double>(2, 0, 8, 0.5)) < 3);
  off(dropped(1, 2, 1e6), Effect::resting);
}

TEST_CASE("resting: without gravity a rotating rod presses on a body that it pushes along") {
  Scene scene = empty(0, 0, 2, 1e-6);
  box(scene, {2, 0.1, 0.1}, 1e6, Point::Zero()).angular_velocity = {0, 0, 1};
  ball(scene, 0.1, 1, {0.5, 0.25, 0});
  at_edge(scene, Effect::resting, 0, 1);
  // It is hit at ½ m/s and leaves the rod's end at more than 2 m/s: pressed all the time.
  const auto run = contact::scenes::make_run(scene, contact::plan_scene(scene));
  run->advance(2);
  CHECK(run->velocity(1).norm() > 2);
  // A body that cannot rotate does not press.
  scene.bodies[0].angular_velocity = Point::Zero();
  scene.bodies[1].position = {0, 0.25, 0};
  scene.bodies[1].velocity.y() = -1;
  off(scene, Effect::resting);
}

TEST_CASE("sleeping: a body that never rests never sleeps") {
  off(dropped(1, 2, 100), Effect::sleeping);
  Scene lying = dropped(1, 0, 100);
  off(lying, Effect::sleeping);  // a level table: gravity is cancelled, nothing presses
  lying.materials[0].friction = 0.25;
  CHECK(plan_scenes::is_on(lying, Effect::sleeping));
  CHECK(plan_scenes::is_on(dropped(0.5, 2, 100), Effect::sleeping));
  off(dropped(0.5, 2, 1), Effect::sleeping);
}

TEST_CASE("resting: an elastic box may rest on a floor, where an elastic ball may not") {
  Scene elastic = dropped(1, 2, 60);
  off(elastic, Effect::resting);
  elastic.bodies[1].shape = contact::BoxShape{{0.5, 0.5, 0.5}};
  CHECK(plan_scenes::is_on(elastic, Effect::resting));
}

TEST_CASE("bounces are left out on one floor, for a tolerance, and where nothing else is hit") {
  off(dropped(0.5, 2, 10), Effect::event_driven);
  Scene corner = dropped(0.5, 2, 10);
  wall(corner, Point::UnitX(), -1);
  corner.bodies[1].velocity.x() = -1;
  at_edge(corner, Effect::event_driven, 2, 5);
  at_edge(dropped(0.5, 2, 10, 0), Effect::event_driven, 2, 7);

  // On a fixed ball, off its top: it cannot rest, but slides off.
  Scene slope = dropped(0.5, 2, 10);
  slope.bodies[0].shape = contact::BallShape{0.5};
  slope.bodies[0].position = {0.1, 0, -0.5};
  at_edge(slope, Effect::event_driven, 2, 6);
  CHECK(8 * 0.1 / 2 * 1 * 1 > 1e4 * *slope.tolerance.position);  // ½ g sin α t² after a second

  // So little gravity that the longest bounce that might be left out has no finite height.
  Scene drifting = dropped(0.5, 0, 1e30, 1e30);
  drifting.gravity = {0, 0, -1e-280};
  drifting.bodies[1].velocity.z() = -1e-250;
  at_edge(drifting, Effect::event_driven, 2, 8);
}

TEST_CASE("a step is at most a tenth of a radian of a spring") {
  for (const double stiffness : {100.0, 10000.0, 1000000.0}) {
    Scene scene = dropped(0.5, 0.1, 1);
    scene.materials[0].stiffness = stiffness;
    const double step = contact::plan_scene(scene).step;
    CAPTURE(stiffness, step);
    CHECK(step > 0);
    const auto pair = contact::pair_material(scene.materials[0], scene.materials[0]);
    CHECK(step * std::sqrt(*pair.stiffness / scene.bodies[1].mass) <= 0.1 * (1 + 1e-12));
  }
}

TEST_CASE("substeps of springs: from the tolerance, unless there is friction or damping") {
  const auto soft = [](double tolerance) {
    Scene scene = dropped(0.5, 0.5, 2, tolerance);
    scene.materials[0].stiffness = 2000;
    return scene;
  };
  const auto notice_of = [](const contact::Plan& plan) {
    for (const std::string& notice : plan.notices)
      if (notice.starts_with("Springs push in substeps of ")) return notice;
    return std::string();
  };
  const double swing = std::sqrt(1000.0);  // two equal springs in a row
  const contact::Plan plan = contact::plan_scene(soft(1e-3));
  const Decision& springs = contact::decision_on(plan, Effect::penalty_contact);
  // Half of the tolerance: v T (ω p)² (1/24 + (1 + ω T/π)/8).
  const double substep = plan.spring_substep;
  const double contacts = 1 + swing * 2 / 3.141592653589793;
  const double speed = contact::scene_bounds(soft(1e-3)).pairs[0].closing;
  const double off = speed * 2 * std::pow(swing * substep, 2) * (1.0 / 24 + contacts / 8);
  CHECK(std::abs(off / 0.5e-3 - 1) <= 1e-9);
  CHECK(std::abs(springs.error / off - 1) <= 1e-9);
  CHECK(springs.because.back().right == 1e-3);
  CHECK(notice_of(plan).find("by an estimate that keeps the tolerance") != std::string::npos);
  // A hundredth of the error for a tenth of the length. (A late hit dips by the tolerance, and is a
  // little faster for that.)
  CHECK(std::abs(contact::plan_scene(soft(1e-5)).spring_substep / substep - 0.1) <= 1e-3);
  // As long as they are for energy's sake.
  const auto is_longest = [&](double length) {
    return std::abs(length * 128 * swing - 1) <= 1e-12;
  };
  CHECK(is_longest(contact::plan_scene(soft(10)).spring_substep));
  CHECK(contact::plan_scene(soft(10)).error < 1);

  // More than a thousand a step, no position error allowed, a damper, friction: no estimate.
  const auto unclaimed = [&](const Scene& scene, const std::string& why) {
    const contact::Plan other = contact::plan_scene(scene);
    const Decision& decision = contact::decision_on(other, Effect::penalty_contact);
    CHECK(is_longest(other.spring_substep));
    CHECK(decision.error == 0);
    CHECK_FALSE(contact::holds(decision.because.back()));
    CHECK_FALSE(contact::decision_on(other, Effect::step_size).proven);
    CHECK(notice_of(other).find(why) != std::string::npos);
  };
  unclaimed(soft(1e-12), "more than 1024 substeps a step");
  unclaimed(soft(0), "no error is accepted");
  Scene damped = soft(1e-3);
  damped.materials[0].damping = least;
  unclaimed(damped, "with friction or damping");
  Scene rough = soft(1e-3);
  rough.materials[0].friction = least;
  unclaimed(rough, "with friction or damping");
  // Its damper acts on the velocity at the end of the substep: of first order.
  const auto height = [](double shorter) {
    Scene scene = dropped(0.5, 0.5, 1.2, 1e-3);
    scene.materials[0].stiffness = 2000;
    scene.materials[0].damping = 2;
    contact::Plan made = contact::plan_scene(scene);
    made.spring_substep /= shorter;
    const auto run = contact::scenes::make_run(scene, made);
    run->advance(1.2);
    return run->position(1).z();
  };
  const double right = height(256);
  const double ratio = (height(4) - right) / (height(8) - right);
  CHECK(ratio > 1.9);
  CHECK(ratio < 2.3);
}

TEST_CASE("resting: a ball that starts an ulp too deep need not come out of the floor") {
  Scene deep = dropped(1 - 0x1p-40, 0, 100);
  deep.bodies[1].position.z() = std::nextafter(0.5, 0);
  deep.bodies[1].velocity.z() = 1e-9;
  at_edge(deep, Effect::resting, 3, 3);
  // Gravity takes all of its speed on less than an ulp: it presses on the floor for ever.
  const Rational depth = exact(0.5) - exact(deep.bodies[1].position.z());
  CHECK(exact(1e-9) * exact(1e-9) < 2 * 8 * depth);
  deep.bodies[1].position.z() = 0.5;
  off(deep, Effect::resting);
}

TEST_CASE("rotation is energy where there is friction") {
  // At rest except for its rotation; 4 m further is another ball.
  Scene scene = empty(0, 0.5, 3, 1e-6);
  scene.gravity = {0, 0, -8};
  wall(scene, Point::UnitZ(), 0);
  ball(scene, 0.5, 1, {0, 0, 0.5}).angular_velocity = {0, 100, 0};
  ball(scene, 0.5, 1, {5, 0, 0.5});
  const contact::Plan plan = contact::plan_scene(scene);
  CHECK(plan.pairs == 3);
  CHECK(contact::decision_on(plan, Effect::several_contacts).on);
  const auto run = contact::scenes::make_run(scene, plan);
  run->advance(3);
  CHECK(run->position(2).x() > 5.5);
  // Smooth, it rotates in its position, and no body meets anything but the floor.
  scene.materials[0].friction = 0;
  CHECK(contact::plan_scene(scene).pairs == 2);
}
