// The edges of rules that plan_rules_*_test.cpp leave, of motion and contacts: each scene was made
// for one condition, one term or one order of a rule, so that a rule without it, or with another in
// its place, gives a wrong answer.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/bouncing.hpp>
#include <contact/plan/plan.hpp>
#include <limits>

#include "plan_at_edge.hpp"
#include "plan_scenes.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

using contact::Decision;
using contact::Effect;
using contact::Plan;
using contact::Scene;
using generators::Random;
using generators::tried;
using oracle::exact;
using oracle::Rational;
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
using plan_scenes::said_of_late_hits;
using plan_scenes::table;
using plan_scenes::wall;

namespace {

constexpr double smallest = std::numeric_limits<double>::denorm_min();

/// All errors that a plan accepts, without rounding.
Rational sum_of_errors(const Plan& plan) {
  Rational sum = 0;
  for (const Decision& made : plan.decisions) sum += exact(made.error);
  return sum;
}

}  // namespace

TEST_CASE("gravity: the fall that is left out is rounded up") {
  Random random(43);
  int edges = 0;
  for (int trial = 0; trial < tried(200); ++trial) {
    const double g = random.uniform(1, 10);
    const double t = random.uniform(0.1, 2);
    const Rational fall = exact(g) * exact(t) * exact(t) / 2;
    const double computed = g * t * t / 2;
    if (exact(computed) >= fall) continue;
    CHECK(is_on(free_ball(g, t, computed), Effect::gravity));
    ++edges;
  }
  CHECK(edges > tried(40));
}

TEST_CASE("gravity: a table is level and supports exactly, in all digits") {
  // The floor is at 10⁻²⁰ m: a ball at ½ m is within it.
  Scene hair = table();
  std::get<contact::HalfSpaceShape>(hair.bodies[0].shape).offset = 1e-20;
  CHECK_FALSE(contact::holds(decision(hair, Effect::gravity).tried.at(2).conditions.at(0)));
  CHECK(is_on(hair, Effect::gravity));
  // A ball that is an ulp too deep does not lie on it.
  Scene deep = table();
  deep.bodies[2].position.z() = std::nextafter(0.5, 0);
  CHECK_FALSE(contact::holds(decision(deep, Effect::gravity).tried.at(2).conditions.at(0)));
  // A normal that is too short by 2⁻⁵⁰: by a rounded product the ball lies on the floor, although
  // it is above it.
  Scene shorter = table();
  shorter.bodies[0].shape = contact::HalfSpaceShape{{0, 0, 1 - 0x1p-50}, 4};
  for (const std::size_t i : {1U, 2U}) shorter.bodies[i].position.z() = 4.5 + 5 * 0x1p-50;
  CHECK(exact(4.5 + 5 * 0x1p-50) - exact(4.0) / exact(1 - 0x1p-50) > exact(0.5));
  CHECK(is_on(shorter, Effect::gravity));
  CHECK_FALSE(contact::holds(decision(shorter, Effect::gravity).tried.at(2).conditions.at(0)));
}

TEST_CASE("rotation: an angular velocity about any axis, and of the smallest size") {
  for (int axis = 0; axis < 3; ++axis) {
    Scene scene = empty(1, 0, 5, 1e-6);
    box(scene, {1, 2, 3}, 1, Point::Zero()).angular_velocity = smallest * Point::Unit(axis);
    at_edge(scene, Effect::rotation, 0, 1);
  }
}

TEST_CASE(
    "the third dimension: angular velocities of either sign, hulls, and any pair of several") {
  Scene flat = empty(1, 0.5, 2, 1e-6);
  box(flat, {1, 2, 3}, 1, Point::Zero(), {1, 0.25, 0}).angular_velocity = {0, 0, 2};
  ball(flat, 0.5, 1, {5, 0, 0});
  ball(flat, 0.5, 1, {5, 2, 0});
  off(flat, Effect::third_dimension);
  for (const double sign : {1.0, -1.0}) {
    for (int axis = 0; axis < 2; ++axis) {
      Scene spinning = flat;
      spinning.bodies[0].angular_velocity(axis) = sign * smallest;
      at_edge(spinning, Effect::third_dimension, 0, 2);
    }
    // Each of the balls meets all others; the last pair of all is level or not.
    for (const std::size_t i : {0U, 1U, 2U}) {
      Scene lifted = flat;
      lifted.bodies[i].position.z() = sign * smallest;
      at_edge(lifted, Effect::third_dimension, 0, 4);
      Scene rising = flat;
      rising.bodies[i].velocity.z() = sign * smallest;
      at_edge(rising, Effect::third_dimension, 0, 1);
    }
  }
  Scene pulled = flat;
  pulled.gravity.z() = -smallest;
  at_edge(pulled, Effect::third_dimension, 0, 0);
  // A hull: its mirror symmetry is not tested.
  Scene hull = empty(1, 0, 2, 1e-6);
  contact::HullShape shape;
  shape.points = {Point(1, 0, 0), Point(-1, 1, 0), Point(-1, -1, 0), Point(-1, 0, 1)};
  ball(hull, 0.5, 1, Point::Zero(), {1, 0, 0});
  auto& body = ball(hull, 0.5, 1, {0, 9, 0});
  body.shape = shape;
  at_edge(hull, Effect::third_dimension, 0, 3);
}

TEST_CASE("the third dimension: a box's edge is its end, and a box is met at more than a point") {
  // The ball's centre is above the edge by 2⁻⁶⁰ m, which the difference of both positions hides.
  Scene scene = empty(1, 0, 2, 1e-6);
  ball(scene, 0.5, 1, {0, 0, 0.25}, {2, 0.25, 0});
  box(scene, {0.5, 2, 0.25}, 0, {2, 0, -0x1p-60});
  CHECK(exact(0.25) + exact(0x1p-60) > exact(0.25));
  at_edge(scene, Effect::third_dimension, 0, 4);
  // A box that is not level with the other one is hit off its centre, and tips.
  Scene boxes = empty(1, 0, 2, 1e-6);
  box(boxes, {0.5, 0.5, 0.5}, 1, {0, 0, 0.25}, {2, 0.25, 0});
  box(boxes, {0.5, 2, 0.75}, 0, {3, 0, 0});
  at_edge(boxes, Effect::third_dimension, 0, 4);
}

TEST_CASE("the gyroscopic term: every body counts, and all of the bound") {
  // Whichever is last.
  for (const bool first : {true, false}) {
    Scene scene = empty(1, 0, 2, 1e-3);
    if (first) box(scene, {1, 2, 3}, 1, Point::Zero()).angular_velocity = {1, 2, 3};
    box(scene, {1, 1, 1}, 1, {50, 0, 0}).angular_velocity = {1, 2, 3};
    if (!first) box(scene, {1, 2, 3}, 1, Point::Zero()).angular_velocity = {1, 2, 3};
    at_edge(scene, Effect::gyroscopic_term, 2, 1);
    CHECK_FALSE(
        contact::holds(decision(scene, Effect::gyroscopic_term).tried.at(0).conditions.at(0)));
  }
  // Moments of inertia as 13 : 10 : 5, a corner √14 m away: R ½ (8/5) (13/5) |ω|² T², whatever the
  // size and the mass.
  for (const double size : {1.0, 0.125}) {
    Scene scene = empty(1, 0, 2, 1e-3);
    box(scene, size * Point(1, 2, 3), 4, Point::Zero()).angular_velocity = {1, 2, 3};
    const double bound = decision(scene, Effect::gyroscopic_term).tried.at(2).conditions.at(1).left;
    const double right = size * std::sqrt(14.0) * 0.5 * 1.6 * 2.6 * 14 * 4;
    CHECK(std::abs(bound / right - 1) < 1e-12);
  }
}

TEST_CASE("the tolerance is kept to the last bit where errors use all of it") {
  // Three errors of a free flight, and a tolerance of about their sum: a little more is enough for
  // all of them, a little less is not, and in between the sum never exceeds the tolerance.
  Random random(44);
  for (int trial = 0; trial < tried(100); ++trial) {
    Scene scene = empty(1, 0, random.uniform(0.1, 1), 1);
    scene.gravity = {0, 0, -random.uniform(1e-4, 1e-3)};
    const Point axis = random.uniform(1e-3, 2e-3) * Point(1, 2, 3);
    box(scene, {1, 2, 3}, 1, {3, 2, 1}, {1, 0, 0}).angular_velocity = axis;
    const double all = contact::plan_scene(scene).error;
    const auto keeps = [&](double tolerance) {
      scene.tolerance.position = tolerance;
      const Plan plan = contact::plan_scene(scene);
      REQUIRE(sum_of_errors(plan) <= exact(tolerance));
      return !contact::decision_on(plan, Effect::double_precision).on &&
             !contact::decision_on(plan, Effect::gravity).on;
    };
    CHECK(keeps(all * (1 + 1e-12)));
    CHECK_FALSE(keeps(all * (1 - 1e-12)));
    double tolerance = all;
    for (int k = 0; k < 4; ++k) tolerance = std::nextafter(tolerance, 0);
    for (int k = 0; k < 8; ++k, tolerance = std::nextafter(tolerance, 1)) keeps(tolerance);
  }
}

TEST_CASE("friction, restitution, springs: whichever pair has them, the first as the last") {
  for (const std::size_t which : {1U, 2U, 3U}) {
    CAPTURE(which);
    const auto balls = [&](const contact::SceneMaterial& other) {
      Scene scene = empty(0, 0.5, 3, 1e-3);
      scene.gravity = {0, 0, -8};
      wall(scene, Point::UnitZ(), 0);
      for (int k = 0; k < 3; ++k) ball(scene, 0.5, 1, {100.0 * k, 0, 1.5}, {1, 0, 0});
      scene.materials.push_back(other);
      for (std::size_t k = 1; k <= 3; ++k) scene.bodies[k].material = k == which ? 0 : 1;
      return scene;
    };
    const Scene one_rubs = balls({"smooth", 0, 0, {}, 0});
    at_edge(one_rubs, Effect::friction, 0, 0);
    Scene one_bounces = balls({"dull", 0, 0, {}, 0});
    one_bounces.materials[0].restitution = 0.5;
    at_edge(one_bounces, Effect::restitution, 0, 0);
    // One falls higher, and is late by more: e = 1.
    Scene one_high = balls({"lively", 1, 0, {}, 0});
    one_high.materials[0] = {"lively too", 1, 0, {}, 0};
    const double low = said_of_late_hits(one_high, 0.001);
    one_high.bodies[which].position.z() = 20.5;
    CHECK(said_of_late_hits(one_high, 0.001) >= 1.3 * low);
    // One comes to rest before the end, the others are high up.
    Scene one_rests = one_high;
    one_rests.materials[0].restitution = 0.5;
    one_rests.bodies[0].material = 1;
    one_rests.bodies[which].position.z() = 1.5;
    for (std::size_t k = 1; k <= 3; ++k)
      if (k != which) one_rests.bodies[k].position.z() = 20.5;
    at_edge(one_rests, Effect::resting, 3, 0);
    one_rests.tolerance.event_order = true;
    at_edge(one_rests, Effect::event_driven, 1, 5);
    // One does not return all: the others alone never rest.
    CHECK_FALSE(contact::holds(decision(one_rests, Effect::resting).tried.at(2).conditions.at(0)));
    CHECK_FALSE(
        contact::holds(decision(one_rests, Effect::event_driven).tried.at(0).conditions.at(5)));
    // Springs: the stiffest and the fastest one sets the pace.
    Scene one_soft = balls({"soft", 0, 0, 100, 0});
    one_soft.materials[0] = {"stiff", 0, 0, 10000, 0};
    one_soft.bodies[0].material = 0;
    one_soft.bodies[which].mass = 1.0 / 64;
    const double fastest = std::sqrt(10000.0 / 2 * 64);
    CHECK(contact::plan_scene(one_soft).step <= 1 / (10 * fastest) * (1 + 1e-12));
  }
  // Both masses move with a spring between them.
  Scene pair = empty(0, 0, 3, 1e-3);
  pair.materials[0].stiffness = 1000;
  ball(pair, 0.5, 1, {-2, 0, 0}, {1, 0, 0});
  ball(pair, 0.5, 1.0 / 64, Point::Zero());
  CHECK(contact::plan_scene(pair).step <= 1 / (10 * std::sqrt(500.0 * 65)) * (1 + 1e-12));
}

TEST_CASE("several contacts: a body that two may meet, though it is named last") {
  // A large ball in the middle, which two meet from both sides that cannot meet each other.
  Scene scene = empty(0.5, 0, 1, 1e-6);
  ball(scene, 0.5, 1, {-51, 0, 0}, {1, 0, 0});
  ball(scene, 0.5, 1, {51, 0, 0}, {-1, 0, 0});
  ball(scene, 50, 1e6, Point::Zero());
  REQUIRE(contact::plan_scene(scene).pairs == 2);
  at_edge(scene, Effect::several_contacts, 0, 0);
}

TEST_CASE("resting: the last bounce by its closed form, from a throw up or down") {
  for (const double up : {-4.0, -0.5, 0.5, 4.0}) {
    CAPTURE(up);
    const double rest = contact::rest_time(contact::bouncing_ball<double>(1, up, 8, 0.5));
    Scene scene = dropped(0.5, 1, rest);
    scene.bodies[1].velocity.z() = up;
    at_edge(scene, Effect::resting, 3, 0);
    scene.duration = rest * (1 - 1e-9);
    off(scene, Effect::resting);
  }
}

TEST_CASE("resting: two that touch, and fall on a floor, need not separate") {
  Scene column = dropped(1, 1, 3);
  ball(column, 0.5, 1, {0, 0, 2.5});
  at_edge(column, Effect::resting, 2, 2);
  // A ball on a slope, or a hair above it, where a normal is rounded.
  Scene slope = dropped(1, 0, 3);
  slope.materials[0].friction = 0.25;
  slope.bodies[0].shape = contact::HalfSpaceShape{{0.6, 0, 0.8}, 0};
  for (const double above : {0.0, 1e-13}) {
    slope.bodies[1].position = Point(0.6, 0, 0.8) * (0.5 + above);
    at_edge(slope, Effect::resting, 2, 2);
  }
  slope.bodies[1].position = Point(0.6, 0, 0.8) * 0.501;
  off(slope, Effect::resting);
}

TEST_CASE("from event to event: a wall with weak gravity towards it has no bound of one hit") {
  // 8 · 2⁻⁵² m/s² along the normal: thrown off at 10⁻⁹ m/s it is back after a million seconds.
  Scene scene = dropped(0.5, 0, 1e8, 0);
  scene.bodies[0].shape = contact::HalfSpaceShape{{1, 0, 0x1p-52}, 0};
  scene.bodies[1].position = {0.5 + 1e-9, 0, 0};
  scene.bodies[1].velocity = {-1e-9, 0, 0};
  CHECK(2 * 1e-9 / (8 * 0x1p-52) < 2e6);
  at_edge(scene, Effect::event_driven, 1, 5);
}
