// The edges of rules that plan_rules_test.cpp leaves: each scene was made for one condition, one
// term or one order of a rule, so that a rule without it, or with another in its place, answers
// wrongly.
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/bouncing.hpp>
#include <contact/plan/plan.hpp>
#include <contact/plan/plan_rules.hpp>
#include <contact/rotation.hpp>
#include <contact/scene/scene_runs.hpp>
#include <contact/scene/scene_solids.hpp>
#include <limits>
#include <utility>
#include <vector>

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
using plan_scenes::stepped;
using plan_scenes::table;
using plan_scenes::unbounded;
using plan_scenes::wall;

namespace {

constexpr double smallest = std::numeric_limits<double>::denorm_min();

/// What hits that are late or missed cost at most, as the rule on continuous detection says.
double said_of_late_hits(const Scene& scene, double step) {
  return decision(scene, Effect::continuous_detection, stepped(step))
      .tried.at(1)
      .conditions.at(1)
      .left;
}

/// Where a body ends in steps in which impacts are looked for, from where it ends without.
double lateness(const Scene& scene, std::size_t body, double step) {
  const auto end = [&](bool looks) {
    contact::PlanOptions options = stepped(step);
    (looks ? options.overrides.with : options.overrides.without) = {Effect::continuous_detection};
    const auto run = contact::scenes::make_run(scene, contact::plan_scene(scene, options));
    run->advance(scene.duration);
    return run->position(body);
  };
  return (end(true) - end(false)).norm();
}

/// All errors that a plan accepts, without rounding.
Rational sum_of_errors(const Plan& plan) {
  Rational sum = 0;
  for (const Decision& made : plan.decisions) sum += exact(made.error);
  return sum;
}

}  // namespace

// ---------------------------------------------------------------- how bodies move

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

TEST_CASE("gravity: a table is level and bears exactly, in all digits") {
  // The floor is at 10⁻²⁰ m: a ball at ½ m is within it.
  Scene hair = table();
  std::get<contact::HalfSpaceShape>(hair.bodies[0].shape).offset = 1e-20;
  CHECK_FALSE(contact::holds(decision(hair, Effect::gravity).tried.at(2).conditions.at(0)));
  CHECK(is_on(hair, Effect::gravity));
  // A ball that is an ulp too deep does not lie on it.
  Scene deep = table();
  deep.bodies[2].position.z() = std::nextafter(0.5, 0);
  CHECK_FALSE(contact::holds(decision(deep, Effect::gravity).tried.at(2).conditions.at(0)));
  // A normal that is too short by 2⁻⁵⁰: a product rounds to a ball that lies, which is above it.
  Scene shorter = table();
  shorter.bodies[0].shape = contact::HalfSpaceShape{{0, 0, 1 - 0x1p-50}, 4};
  for (const std::size_t i : {1U, 2U}) shorter.bodies[i].position.z() = 4.5 + 5 * 0x1p-50;
  CHECK(exact(4.5 + 5 * 0x1p-50) - exact(4.0) / exact(1 - 0x1p-50) > exact(0.5));
  CHECK(is_on(shorter, Effect::gravity));
  CHECK_FALSE(contact::holds(decision(shorter, Effect::gravity).tried.at(2).conditions.at(0)));
}

TEST_CASE("rotation: a spin about any axis, and of the smallest size") {
  for (int axis = 0; axis < 3; ++axis) {
    Scene scene = empty(1, 0, 5, 1e-6);
    box(scene, {1, 2, 3}, 1, Point::Zero()).spin = smallest * Point::Unit(axis);
    at_edge(scene, Effect::rotation, 0, 1);
  }
}

TEST_CASE("the third dimension: spins of either sign, hulls, and any pair of several") {
  Scene flat = empty(1, 0.5, 2, 1e-6);
  box(flat, {1, 2, 3}, 1, Point::Zero(), {1, 0.25, 0}).spin = {0, 0, 2};
  ball(flat, 0.5, 1, {5, 0, 0});
  ball(flat, 0.5, 1, {5, 2, 0});
  off(flat, Effect::third_dimension);
  for (const double sign : {1.0, -1.0}) {
    for (int axis = 0; axis < 2; ++axis) {
      Scene spinning = flat;
      spinning.bodies[0].spin(axis) = sign * smallest;
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
  // A hull: nobody asks whether it has a mirror.
  Scene hull = empty(1, 0, 2, 1e-6);
  contact::HullShape shape;
  shape.points = {Point(1, 0, 0), Point(-1, 1, 0), Point(-1, -1, 0), Point(-1, 0, 1)};
  ball(hull, 0.5, 1, Point::Zero(), {1, 0, 0});
  auto& body = ball(hull, 0.5, 1, {0, 9, 0});
  body.shape = shape;
  at_edge(hull, Effect::third_dimension, 0, 3);
}

TEST_CASE("the third dimension: a box's edge is its end, and a box is met at more than a point") {
  // The ball's middle is above the edge by 2⁻⁶⁰ m, which the difference of both places hides.
  Scene scene = empty(1, 0, 2, 1e-6);
  ball(scene, 0.5, 1, {0, 0, 0.25}, {2, 0.25, 0});
  box(scene, {0.5, 2, 0.25}, 0, {2, 0, -0x1p-60});
  CHECK(exact(0.25) + exact(0x1p-60) > exact(0.25));
  at_edge(scene, Effect::third_dimension, 0, 4);
  // A box that is not level with the one that it meets is met beside its middle, and tips.
  Scene boxes = empty(1, 0, 2, 1e-6);
  box(boxes, {0.5, 0.5, 0.5}, 1, {0, 0, 0.25}, {2, 0.25, 0});
  box(boxes, {0.5, 2, 0.75}, 0, {3, 0, 0});
  at_edge(boxes, Effect::third_dimension, 0, 4);
}

TEST_CASE("the gyroscopic term: every body counts, and all of the bound") {
  // Whichever comes last.
  for (const bool first : {true, false}) {
    Scene scene = empty(1, 0, 2, 1e-3);
    if (first) box(scene, {1, 2, 3}, 1, Point::Zero()).spin = {1, 2, 3};
    box(scene, {1, 1, 1}, 1, {50, 0, 0}).spin = {1, 2, 3};
    if (!first) box(scene, {1, 2, 3}, 1, Point::Zero()).spin = {1, 2, 3};
    at_edge(scene, Effect::gyroscopic_term, 2, 1);
    CHECK_FALSE(
        contact::holds(decision(scene, Effect::gyroscopic_term).tried.at(0).conditions.at(0)));
  }
  // Moments as 13 : 10 : 5, a corner √14 m away: R ½ (8/5) (13/5) |ω|² T², and it is that whatever
  // the size and the mass.
  for (const double size : {1.0, 0.125}) {
    Scene scene = empty(1, 0, 2, 1e-3);
    box(scene, size * Point(1, 2, 3), 4, Point::Zero()).spin = {1, 2, 3};
    const double bound = decision(scene, Effect::gyroscopic_term).tried.at(2).conditions.at(1).left;
    const double right = size * std::sqrt(14.0) * 0.5 * 1.6 * 2.6 * 14 * 4;
    CHECK(std::abs(bound / right - 1) < 1e-12);
  }
}

TEST_CASE("the tolerance is kept to the last bit where errors fill it") {
  // Three errors of a free flight, and a tolerance of about what they come to: a little more is
  // enough for all of them, a little less is not, and in between none is more than there is.
  Random random(44);
  for (int trial = 0; trial < tried(100); ++trial) {
    Scene scene = empty(1, 0, random.uniform(0.1, 1), 1);
    scene.gravity = {0, 0, -random.uniform(1e-4, 1e-3)};
    const Point axis = random.uniform(1e-3, 2e-3) * Point(1, 2, 3);
    box(scene, {1, 2, 3}, 1, {3, 2, 1}, {1, 0, 0}).spin = axis;
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

// ---------------------------------------------------------------- contacts

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
  // Both masses give way to a spring between them.
  Scene pair = empty(0, 0, 3, 1e-3);
  pair.materials[0].stiffness = 1000;
  ball(pair, 0.5, 1, {-2, 0, 0}, {1, 0, 0});
  ball(pair, 0.5, 1.0 / 64, Point::Zero());
  CHECK(contact::plan_scene(pair).step <= 1 / (10 * std::sqrt(500.0 * 65)) * (1 + 1e-12));
}

TEST_CASE("several contacts: who is met by two, though it is named last") {
  // A large ball in the middle, which two meet from both sides that cannot meet each other.
  Scene scene = empty(0.5, 0, 1, 1e-6);
  ball(scene, 0.5, 1, {-51, 0, 0}, {1, 0, 0});
  ball(scene, 0.5, 1, {51, 0, 0}, {-1, 0, 0});
  ball(scene, 50, 1e6, Point::Zero());
  REQUIRE(contact::plan_scene(scene).pairs == 2);
  at_edge(scene, Effect::several_contacts, 0, 0);
}

TEST_CASE("resting: the last bounce by its closed form, thrown up or down") {
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

TEST_CASE("resting: two that touch, and fall on a floor, need not part") {
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

TEST_CASE("from event to event: a wall that hardly pulls has no budget of one hit") {
  // 8 · 2⁻⁵² m/s² along the normal: thrown off at 10⁻⁹ m/s it is back after a million seconds.
  Scene scene = dropped(0.5, 0, 1e8, 0);
  scene.bodies[0].shape = contact::HalfSpaceShape{{1, 0, 0x1p-52}, 0};
  scene.bodies[1].position = {0.5 + 1e-9, 0, 0};
  scene.bodies[1].velocity = {-1e-9, 0, 0};
  CHECK(2 * 1e-9 / (8 * 0x1p-52) < 2e6);
  at_edge(scene, Effect::event_driven, 1, 5);
}

// ---------------------------------------------------------------- between two steps

TEST_CASE("late hits: no bound for what loses speed, hits too often, or rubs in flight") {
  // It does not come to rest before the end, and sinks all the same.
  Scene lossy = dropped(0.9, 2, 1.5, 1);
  lossy.materials[0].friction = 0.25;
  CHECK(std::isinf(said_of_late_hits(lossy, 0.01)));
  // More than a million hits in the whole time.
  Scene often = dropped(1, 1e-9, 60, 1);
  often.materials[0].friction = 0.25;
  CHECK(2 * std::sqrt(2 * 1e-9 / 8) * 1e6 < 60);
  CHECK(std::isinf(said_of_late_hits(often, 0.01)));
  Scene rough = empty(1, 0.5, 1, 1);
  ball(rough, 0.5, 1, {-2, 0, 0}, {2, 0, 0});
  ball(rough, 0.5, 1, Point::Zero());
  CHECK(std::isinf(said_of_late_hits(rough, 0.01)));
  rough.materials[0].friction = 0;
  CHECK(std::isfinite(said_of_late_hits(rough, 0.01)));
}

TEST_CASE("late hits: head on, what two come back from each other by is all of it") {
  // Large and slow, so that the slant is none. The hit comes 1 ms after a step of 50 ms.
  const double h = 0.05;
  Scene scene = empty(1, 0, 0.5, 1);
  ball(scene, 50, 1, {-100 - 0.201, 0, 0}, {1, 0, 0});
  ball(scene, 50, 1e9, Point::Zero());
  const double late = lateness(scene, 0, h);
  CHECK(late > 0.97 * 2 * h);
  CHECK(late <= said_of_late_hits(scene, h));
  // Thrown as far as the hit's slant says, and not more than it does in all of the time.
  CHECK(said_of_late_hits(scene, h) <= 2 * h * (1 + 0.5 / 100) * (1 + 1e-3));
}

TEST_CASE("grazing hits: a normal that is late by a step is turned by all of it") {
  // It touches at cos θ = 0.02 just after a step, and the next step finds it at 0.01: of the
  // velocity 2 · 0.01 m/s along the normal are missing, for ten seconds.
  const double h = 0.01;
  Scene scene = empty(1, 0, 10, 10);
  ball(scene, 0.5, 1, {-0.02 - 1e-7, std::sqrt(1 - 0.02 * 0.02), 0}, {1, 0, 0});
  ball(scene, 0.5, 1e9, Point::Zero());
  const double thrown = lateness(scene, 0, h);
  CHECK(thrown > 0.95 * 0.2);
  CHECK(thrown <= said_of_late_hits(scene, h));
  // Whichever of two such pairs comes first.
  Scene two = scene;
  ball(two, 50, 1, {-104, 500, 0}, {0.5, 0, 0});
  ball(two, 50, 1e9, {0, 500, 0});
  CHECK(thrown <= said_of_late_hits(two, h));
  std::rotate(two.bodies.begin(), two.bodies.begin() + 2, two.bodies.end());
  CHECK(thrown <= said_of_late_hits(two, h));
  // What is accepted is what was compared.
  const Decision accepted = decision(scene, Effect::continuous_detection, stepped(h));
  REQUIRE_FALSE(accepted.on);
  CHECK(accepted.error == said_of_late_hits(scene, h));
}

// ---------------------------------------------------------------- rest and sleep

TEST_CASE("hops that are left out: what bounds them, wall by wall") {
  const auto resting = [](const Scene& scene) {
    return decision(scene, Effect::resting, stepped(0.01)).error;
  };
  const auto sleeping = [](const Scene& scene) {
    return decision(scene, Effect::sleeping, stepped(0.01)).error;
  };
  const Scene alone = dropped(0.5, 2, 10, 1e-4);
  REQUIRE(std::isfinite(resting(alone)));
  REQUIRE(std::isfinite(sleeping(alone)));
  const auto has_none = [&](const Scene& scene) {
    CHECK(resting(scene) == unbounded);
    CHECK(sleeping(scene) == unbounded);
  };
  // On a ball it lies on no plane, and a box rocks from corner to corner.
  Scene on_ball = alone;
  on_ball.bodies[0].shape = contact::BallShape{0.5};
  on_ball.bodies[0].position = {0, 0, -0.5};
  has_none(on_ball);
  Scene rocks = alone;
  rocks.bodies[1].shape = contact::BoxShape{{0.5, 0.5, 0.5}};
  rocks.bodies[1].orientation = contact::exponential<double>({0.3, 0.2, 0});
  has_none(rocks);
  // A soft wall beside the floor; one that leans over it by 10⁻⁷; two slopes at a right angle.
  Scene soft = alone;
  soft.materials.push_back({"soft", 0.5, 0, 1000, 0});
  wall(soft, Point::UnitX(), -5);
  soft.bodies.back().material = 1;
  has_none(soft);
  Scene leans = alone;
  wall(leans, {1, 0, -1e-7}, -5);
  has_none(leans);
  Scene groove = alone;
  groove.bodies[0].shape = contact::HalfSpaceShape{{0.6, 0, 0.8}, 0};
  wall(groove, {-0.8, 0, 0.6}, 0);
  has_none(groove);
  // Nobody lies on the floor but one whom another may hit that is named first, and never comes
  // down.
  Scene hit = empty(0.5, 0, 0.5, 1e-4);
  hit.gravity = {0, 0, -8};
  wall(hit, Point::UnitZ(), 0);
  ball(hit, 0.5, 1, {0, 0, 3});
  ball(hit, 0.5, 1, {0, 0, 0.7});
  REQUIRE(contact::plan_scene(hit).pairs == 2);
  CHECK(resting(hit) == unbounded);
  // Nor if that one's hits leave out no hop themselves.
  hit.materials.push_back({"dull", 0, 0, {}, 0});
  hit.bodies[1].material = 1;
  CHECK(resting(hit) == unbounded);
  std::swap(hit.bodies[1], hit.bodies[2]);
  REQUIRE(contact::plan_scene(hit).pairs == 2);
  CHECK(resting(hit) == unbounded);
  // A wall that is all but upright presses a little; one that is upright does not.
  Scene steep = alone;
  const double slight = 1e-4;
  steep.bodies[0].shape =
      contact::HalfSpaceShape{{std::sqrt(1 - slight * slight), 0, slight}, -0.50075};
  CHECK(resting(steep) > 0);
  CHECK(resting(steep) <= 8 * slight * 0.01 * 0.01 / 8 / 4 * (1 + 1e-9));
}

TEST_CASE("sleep has no bound for what slides along an upright wall, unless it is a smooth ball") {
  const auto sleeping = [](const Scene& scene) {
    return decision(scene, Effect::sleeping, stepped(0.01)).error;
  };
  // A ball on a floor far away, and one that falls along a wall.
  Scene shaft = dropped(0.5, 2, 10, 1e-4);
  ball(shaft, 0.5, 1, {1000, 0, 1000}, {-1, 0, 0});
  box(shaft, {0.5, 0.5, 0.5}, 0, {-1000, 0, 1000});
  wall(shaft, Point::UnitX(), 999);
  shaft.bodies[1].position.x() = 2000;
  REQUIRE(std::isfinite(sleeping(shaft)));
  Scene soft = shaft;
  soft.materials.push_back({"soft", 0.5, 0, 1000, 0});
  soft.bodies.back().material = 1;
  CHECK(sleeping(soft) == unbounded);
  Scene rough = shaft;
  rough.materials.push_back({"rough", 0.5, 0.5, {}, 0});
  rough.bodies.back().material = rough.bodies[2].material = 1;
  CHECK(sleeping(rough) == unbounded);
  Scene corners = shaft;
  corners.bodies[2].shape = contact::BoxShape{{0.5, 0.5, 0.5}};
  CHECK(sleeping(corners) == unbounded);
}

TEST_CASE("sleep: not so fast that a short scene would tell") {
  // Slower than so many m/s for the whole of a quarter of a second is less than the share; so it is
  // for ten seconds if what pushes it goes on, twice in a second.
  for (const double duration : {0.25, 10.0}) {
    Scene scene = dropped(0, 0.01, duration, 1e-4);
    scene.materials[0].friction = 0.25;
    const Plan plan = contact::plan_scene(scene, stepped(0.01));
    const double share = contact::sleeping_share(contact::plan_question(scene));
    CHECK(share == 0.5e-4);
    REQUIRE(plan.sleep_speed > 0);
    CHECK(exact(plan.sleep_speed) * exact(duration) <= exact(share) * (1 + Rational(1, 1000000)));
    CHECK(exact(plan.sleep_speed) * exact(duration) * exact(duration) * 2 <=
          exact(share) * (1 + Rational(1, 1000000)));
  }
}

TEST_CASE("springs, hops and sleep together keep the tolerance") {
  Scene scene = dropped(0.5, 0.5, 2, 1e-3);
  ball(scene, 0.5, 1, {100, 0, 1});
  scene.materials.push_back({"soft", 0.5, 0, 2000, 0});
  scene.bodies[2].material = 1;
  const Plan plan = contact::plan_scene(scene, stepped(0.01));
  CHECK(contact::decision_on(plan, Effect::penalty_contact).error > 0.49e-3);
  // The soft one's sleep has no bound. What has one is within the tolerance.
  Rational sum = 0;
  for (const Decision& made : plan.decisions)
    if (std::isfinite(made.error)) sum += exact(made.error);
  CHECK(sum <= exact(1e-3));
  CHECK(plan.rest_height <= 0.25e-3 * (1 + 1e-12));
  const Decision& sleeping = contact::decision_on(plan, Effect::sleeping);
  CHECK(sleeping.because.back().left <= 0.5e-3);
  CHECK(contact::holds(sleeping.because.back()));
}

TEST_CASE("without gravity no hop is left out, though something may be pressed") {
  Scene scene = empty(0.5, 0, 2, 1e-3);
  box(scene, {2, 0.1, 0.1}, 1e6, Point::Zero()).spin = {0, 0, 1};
  ball(scene, 0.1, 1, {0.5, 0.25, 0});
  wall(scene, Point::UnitX(), -50);
  const Plan plan = contact::plan_scene(scene, stepped(0.01));
  REQUIRE(contact::decision_on(plan, Effect::resting).on);
  CHECK(plan.rest_height == 0);
  // What falls with all others has no floor to lie on, though two of it meet last.
  Scene last = empty(0.5, 0, 0.5, 1e-4);
  last.gravity = {0, 0, -8};
  wall(last, Point::UnitZ(), 0);
  ball(last, 0.5, 1, {0, 0, 0.7});
  ball(last, 0.5, 1, {0, 0, 3});
  CHECK(contact::plan_scene(last, stepped(0.01)).rest_height > 0);
}

TEST_CASE(
    "hops from event to event are as high as the cutoff says, in a run that goes on in steps") {
  const Plan plan = contact::plan_scene(dropped(0.5, 2, 10, 1e-6));
  const Decision& events = contact::decision_on(plan, Effect::event_driven);
  REQUIRE(events.on);
  const double hop = 8 * plan.cutoff * plan.cutoff / 8;
  CHECK(std::abs(events.error / hop - 1) <= 1e-12);
  CHECK(std::abs(plan.rest_height / hop - 1) <= 1e-12);
}

// ---------------------------------------------------------------- time and digits

TEST_CASE("from event to event: who touches at first hands a hit on, unless it is alone") {
  // Two hits on one instant: which comes first decides.
  Scene row = empty(1, 0, 3, 0);
  ball(row, 0.5, 1, {-2, 0, 0}, {1, 0, 0});
  ball(row, 0.5, 2, Point::Zero());
  ball(row, 0.5, 4, {1, 0, 0});
  at_edge(row, Effect::event_driven, 0, 6);
  row.bodies.pop_back();
  off(row, Effect::event_driven);
}

TEST_CASE("float: only numbers of a size that it squares, and no digit less than it has") {
  Scene endless = empty(1, 0, 1e-15, 1e-3);
  endless.gravity = {0, 0, -1e19};
  ball(endless, 0.5, 1, Point::Zero());
  at_edge(endless, Effect::double_precision, 0, 3);
  Scene whirling = empty(1, 0, 1e-22, 1e-3);
  box(whirling, {1, 1, 1}, 1, Point::Zero()).spin = {0, 0, 1e19};
  at_edge(whirling, Effect::double_precision, 0, 3);
  Scene tiny = empty(1, 0, 1, 0x1p-81);
  ball(tiny, 0.5, 1, Point::Zero(), {1e-38, 0, 0});
  at_edge(tiny, Effect::double_precision, 0, 3);
  // Ten thousand kilometres of way, of fall and of turning, each by itself: floats there are a
  // metre apart.
  Scene far = free_ball(0, 1, 0.3);
  far.bodies[0].velocity = {1e7 + 1, 0, 0};
  at_edge(far, Effect::double_precision, 0, 1);
  Scene deep = free_ball(2e7, 1, 0.3);
  at_edge(deep, Effect::double_precision, 0, 1);
  Scene wide = empty(1, 0, 1, 0.3);
  box(wide, Point::Constant(1e7), 1, Point::Zero()).spin = {0, 0, 1e-3};
  ball(wide, 0.5, 1, {0, 0, 4e7});
  at_edge(wide, Effect::double_precision, 0, 1);
  Scene often = empty(1, 0, 1, 1e-3);
  box(often, {1, 1, 1}, 1, Point::Zero()).spin = {0, 0, 1e5};
  ball(often, 0.5, 1, {0, 0, 4});
  at_edge(often, Effect::double_precision, 0, 1);
  box(often, {1, 1, 1}, 1, {0, 0, 8}).spin = {0, 0, 1e-3};
  at_edge(often, Effect::double_precision, 0, 1);
}

TEST_CASE("float: a flight and a turn are off by less than is said, but not by much less") {
  Random random(45);
  constexpr double u = 0x1p-24;
  double most = 0;
  double most_turned = 0;
  for (int trial = 0; trial < tried(4000); ++trial) {
    const double x = random.uniform(-1, 1);
    const double v = random.uniform(1, 2);
    const double t = random.uniform(1, 2);
    const float as_float = static_cast<float>(x) + static_cast<float>(v) * static_cast<float>(t);
    const double size = std::abs(x) + v * t;
    most = std::max(most, std::abs(static_cast<double>(as_float) - (x + v * t)) / (u * size));
    const double fast = random.uniform(1, 20);
    const Point spin = fast * Point(random.uniform(), 0.5, 0.25).normalized();
    const contact::Vector3<float> half_turned = (spin.cast<float>() * static_cast<float>(t));
    const auto turned = contact::matrix_of(contact::exponential<float>(half_turned));
    const auto right = contact::matrix_of(contact::exponential<double>(spin * t));
    const Point corner = Point(1, 1, 1).normalized();
    const Point aside = (turned * corner.cast<float>()).cast<double>() - right * corner;
    most_turned = std::max(most_turned, aside.norm() / (u * (1 + fast * t)));
  }
  CAPTURE(most, most_turned);
  CHECK(most <= 16);
  CHECK(most > 2);
  CHECK(most_turned <= 32);
  // What the rule says of both: 16 and 32 of these.
  Scene moved = free_ball(0, 1.5, 1);
  moved.bodies[0].velocity = {3, 0, 0};
  CHECK(decision(moved, Effect::double_precision).tried.at(0).conditions.at(1).left >=
        most * u * 4.5);
}

TEST_CASE("the step: no longer than what is written, nor proven if a hit may be missed") {
  Scene scene = dropped(1, 2, 1.5, 1e-3);
  scene.materials[0].friction = 0.5;
  scene.bodies[1].velocity.x() = 1;
  scene.tolerance.position = 1e-9;
  CHECK(contact::plan_scene(scene).step == 1.0 / 60);
  scene.output.every = 0x1p-8;
  CHECK(contact::plan_scene(scene).step == 0x1p-8);
  // A crowd whose hits come later than there is room for.
  Scene crowd = empty(1, 0, 2, 1e-3);
  wall(crowd, {1, 0, 0}, -10);
  for (int k = 0; k < 65; ++k) ball(crowd, 0.1, 1, {0, 100.0 * k, 0}, {-6, 0, 0});
  contact::PlanOptions options = stepped(1.0 / 60);
  options.overrides.with = {Effect::continuous_detection};
  CHECK(std::isinf(decision(crowd, Effect::step_size, options).error));
  CHECK(std::isinf(contact::plan_scene(crowd, options).error));
}

// ---------------------------------------------------------------- the horizon

TEST_CASE("the horizon: a die on a floor, and balls that a spring throws up") {
  Scene die = dropped(1, 1, 30);
  die.bodies[1].shape = contact::BoxShape{{0.2, 0.25, 0.3}};
  die.bodies[1].inertia = contact::solid_inertia(die.bodies[1].shape, 1);
  die.bodies[1].spin = {1, 2, 3};
  at_edge(die, Effect::horizon, 0, 1);
  Scene column = dropped(0, 1, 30);
  ball(column, 0.5, 2, {0, 0, 3});
  off(column, Effect::horizon);  // nothing comes back
  column.materials[0].stiffness = 1000;
  CHECK(is_on(column, Effect::horizon));
  // Two that fall and bounce on one line, of which one alone would be known.
  Scene two = dropped(1, 1, 30);
  off(two, Effect::horizon);
  ball(two, 0.5, 2, {0, 0, 3});
  CHECK(is_on(two, Effect::horizon));
}

TEST_CASE("the horizon does not depend on who is named first") {
  // Unlike in everything, among posts, on its way down.
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

TEST_CASE("the horizon: the fastest sets the pace, by its speed or by what it may be given") {
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
  // What begins at rest and falls has a pace as well.
  Scene falls = gas(0);
  falls.bodies[9].velocity.setZero();
  falls.gravity = {0, 0, -8};
  CHECK(decision(falls, Effect::horizon).value.has_value());
  // A hit of two balls is spread by other hits of theirs: sooner than that of one among posts.
  Scene alone = gas(0);
  for (std::size_t k = 6; k < alone.bodies.size(); ++k)
    if (k != 9) alone.bodies[k].moves = false;
  CHECK(pace(alone) > pace(gas(0)));
  // A large post among them makes nobody rounder, and far away an ulp is longer.
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

TEST_CASE("the horizon: what turns may touch as early as its corners come") {
  // A rod that turns at 1 rad/s, 2.02 m long to each side, one metre above a floor for its middle.
  const auto first = [](double spin, bool both) {
    Scene scene = empty(1, 0, 1000, 1e-6);
    plan_scenes::add(scene, contact::CapsuleShape{0.25, 2}, 1, {0, 0, 1}, {0, 0, -0.125}).spin = {
        spin, 0, 0};
    if (both) {
      plan_scenes::add(scene, contact::CapsuleShape{0.25, 2}, 1, {0, 6, 1}, {0, -1, 0}).spin = {
          spin, 0, 0};
    } else {
      wall(scene, Point::UnitZ(), -9);
    }
    return contact::detail::first_touch(contact::plan_question(scene));
  };
  // Surfaces move at 2.25 m/s and more.
  for (const bool both : {false, true}) {
    CAPTURE(both);
    const double still = first(0, both);
    CHECK(first(1, both) < still / 1.5);
    CHECK(first(-2, both) <= first(1, both));
  }
  CHECK(first(1, true) <= 5.5 / (1 + 2 * 2.25) * (1 + 1e-9));
  // What is at rest over a ball that stands falls on it after a second.
  Scene over = empty(1, 0, 1000, 1e-6);
  over.gravity = {0, 0, -10};
  ball(over, 0.5, 0, Point::Zero());
  ball(over, 0.5, 1, {0, 0, 6});
  CHECK(contact::detail::first_touch(contact::plan_question(over)) <= 1 + 1e-9);
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
