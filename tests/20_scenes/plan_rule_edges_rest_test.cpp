// The edges of rules that plan_rules_*_test.cpp leave, between two steps and at rest: each scene
// was made for one condition, one term or one order of a rule, so that a rule without it, or with
// another in its place, gives a wrong answer.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/plan/plan.hpp>
#include <contact/plan/plan_rules.hpp>
#include <contact/quaternion.hpp>
#include <contact/scene/scene_runs.hpp>
#include <utility>

#include "plan_at_edge.hpp"
#include "plan_scenes.hpp"
#include "support/oracle.hpp"

using contact::Decision;
using contact::Effect;
using contact::Plan;
using contact::Scene;
using oracle::exact;
using oracle::Rational;
using plan_scenes::ball;
using plan_scenes::box;
using plan_scenes::decision;
using plan_scenes::dropped;
using plan_scenes::empty;
using plan_scenes::Point;
using plan_scenes::said_of_late_hits;
using plan_scenes::stepped;
using plan_scenes::unbounded;
using plan_scenes::wall;

namespace {

/// The displacement of a body's final position by leaving out detection between steps.
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

}  // namespace

TEST_CASE(
    "late hits: no bound for balls that lose speed, hit too often, or have friction in flight") {
  // It does not come to rest before the end, but sinks.
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

TEST_CASE("late hits: head on, the rebound of the two is the whole error") {
  // Large and slow, so that the hit is not oblique. It happens 1 ms after a step of 50 ms.
  const double h = 0.05;
  Scene scene = empty(1, 0, 0.5, 1);
  ball(scene, 50, 1, {-100 - 0.201, 0, 0}, {1, 0, 0});
  ball(scene, 50, 1e9, Point::Zero());
  const double late = lateness(scene, 0, h);
  CHECK(late > 0.97 * 2 * h);
  CHECK(late <= said_of_late_hits(scene, h));
  // Displaced by the oblique hit, and at most by its motion in the whole time.
  CHECK(said_of_late_hits(scene, h) <= 2 * h * (1 + 0.5 / 100) * (1 + 1e-3));
}

TEST_CASE("grazing hits: a normal that is late by a step is rotated by the whole step") {
  // It touches at cos θ = 0.02 just after a step, and the next step finds it at 0.01: of the
  // velocity 2 · 0.01 m/s along the normal are missing, for ten seconds.
  const double h = 0.01;
  Scene scene = empty(1, 0, 10, 10);
  ball(scene, 0.5, 1, {-0.02 - 1e-7, std::sqrt(1 - 0.02 * 0.02), 0}, {1, 0, 0});
  ball(scene, 0.5, 1e9, Point::Zero());
  const double thrown = lateness(scene, 0, h);
  CHECK(thrown > 0.95 * 0.2);
  CHECK(thrown <= said_of_late_hits(scene, h));
  // Whichever of two such pairs is first.
  Scene two = scene;
  ball(two, 50, 1, {-104, 500, 0}, {0.5, 0, 0});
  ball(two, 50, 1e9, {0, 500, 0});
  CHECK(thrown <= said_of_late_hits(two, h));
  std::rotate(two.bodies.begin(), two.bodies.begin() + 2, two.bodies.end());
  CHECK(thrown <= said_of_late_hits(two, h));
  // The error accepted is the one that was compared.
  const Decision accepted = decision(scene, Effect::continuous_detection, stepped(h));
  REQUIRE_FALSE(accepted.on);
  CHECK(accepted.error == said_of_late_hits(scene, h));
}

TEST_CASE("bounces that are left out: their bounds, wall by wall") {
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
  // A ball is no plane to lie on, and a box rocks from corner to corner.
  Scene on_ball = alone;
  on_ball.bodies[0].shape = contact::BallShape{0.5};
  on_ball.bodies[0].position = {0, 0, -0.5};
  has_none(on_ball);
  Scene rocks = alone;
  rocks.bodies[1].shape = contact::BoxShape{{0.5, 0.5, 0.5}};
  rocks.bodies[1].orientation = contact::exponential<double>({0.3, 0.2, 0});
  has_none(rocks);
  // A compliant wall beside the floor; one that overhangs it by 10⁻⁷; two slopes at a right angle.
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
  // No body lies on the floor except one that another, named first, may hit, and that never comes
  // down.
  Scene hit = empty(0.5, 0, 0.5, 1e-4);
  hit.gravity = {0, 0, -8};
  wall(hit, Point::UnitZ(), 0);
  ball(hit, 0.5, 1, {0, 0, 3});
  ball(hit, 0.5, 1, {0, 0, 0.7});
  REQUIRE(contact::plan_scene(hit).pairs == 2);
  CHECK(resting(hit) == unbounded);
  // Nor if hits on that one leave out no bounce.
  hit.materials.push_back({"dull", 0, 0, {}, 0});
  hit.bodies[1].material = 1;
  CHECK(resting(hit) == unbounded);
  std::swap(hit.bodies[1], hit.bodies[2]);
  REQUIRE(contact::plan_scene(hit).pairs == 2);
  CHECK(resting(hit) == unbounded);
  // A nearly vertical wall presses a little; a vertical one does not.
  Scene steep = alone;
  const double slight = 1e-4;
  steep.bodies[0].shape =
      contact::HalfSpaceShape{{std::sqrt(1 - slight * slight), 0, slight}, -0.50075};
  CHECK(resting(steep) > 0);
  CHECK(resting(steep) <= 8 * slight * 0.01 * 0.01 / 8 / 4 * (1 + 1e-9));
}

TEST_CASE(
    "sleep has no bound for a body that slides along a vertical wall, unless it is a smooth ball") {
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

TEST_CASE("sleep: not at a speed that a short scene would show") {
  // Slower than so many m/s for a whole quarter of a second is less than the share; so it is for
  // ten seconds if its acceleration continues, twice in a second.
  for (const double duration : {0.25, 10.0}) {
    Scene scene = dropped(0, 0.01, duration, 1e-4);
    scene.materials[0].friction = 0.25;
    const Plan plan = contact::plan_scene(scene, stepped(0.01));
    const double share = contact::sleeping_share(contact::plan_input(scene));
    CHECK(share == 0.5e-4);
    REQUIRE(plan.sleep_speed > 0);
    CHECK(exact(plan.sleep_speed) * exact(duration) <= exact(share) * (1 + Rational(1, 1000000)));
    CHECK(exact(plan.sleep_speed) * exact(duration) * exact(duration) * 2 <=
          exact(share) * (1 + Rational(1, 1000000)));
  }
}

TEST_CASE("springs, bounces and sleep together keep the tolerance") {
  Scene scene = dropped(0.5, 0.5, 2, 1e-3);
  ball(scene, 0.5, 1, {100, 0, 1});
  scene.materials.push_back({"soft", 0.5, 0, 2000, 0});
  scene.bodies[2].material = 1;
  const Plan plan = contact::plan_scene(scene, stepped(0.01));
  CHECK(contact::decision_on(plan, Effect::penalty_contact).error > 0.49e-3);
  // The compliant body's sleep has no bound. A sleep with a bound is within the tolerance.
  Rational sum = 0;
  for (const Decision& made : plan.decisions)
    if (std::isfinite(made.error)) sum += exact(made.error);
  CHECK(sum <= exact(1e-3));
  CHECK(plan.rest_height <= 0.25e-3 * (1 + 1e-12));
  const Decision& sleeping = contact::decision_on(plan, Effect::sleeping);
  CHECK(sleeping.because.back().left <= 0.5e-3);
  CHECK(contact::holds(sleeping.because.back()));
}

TEST_CASE("without gravity no bounce is left out, though bodies may be pressed together") {
  Scene scene = empty(0.5, 0, 2, 1e-3);
  box(scene, {2, 0.1, 0.1}, 1e6, Point::Zero()).angular_velocity = {0, 0, 1};
  ball(scene, 0.1, 1, {0.5, 0.25, 0});
  wall(scene, Point::UnitX(), -50);
  const Plan plan = contact::plan_scene(scene, stepped(0.01));
  REQUIRE(contact::decision_on(plan, Effect::resting).on);
  CHECK(plan.rest_height == 0);
  // Bodies that all fall have no floor to lie on, though two of them meet last.
  Scene last = empty(0.5, 0, 0.5, 1e-4);
  last.gravity = {0, 0, -8};
  wall(last, Point::UnitZ(), 0);
  ball(last, 0.5, 1, {0, 0, 0.7});
  ball(last, 0.5, 1, {0, 0, 3});
  CHECK(contact::plan_scene(last, stepped(0.01)).rest_height > 0);
}

TEST_CASE("bounces are left out at the cutoff's height in a run that goes on in steps") {
  const Plan plan = contact::plan_scene(dropped(0.5, 2, 10, 1e-6));
  const Decision& events = contact::decision_on(plan, Effect::event_driven);
  REQUIRE(events.on);
  const double bounce = 8 * plan.cutoff * plan.cutoff / 8;
  CHECK(std::abs(events.error / bounce - 1) <= 1e-12);
  CHECK(std::abs(plan.rest_height / bounce - 1) <= 1e-12);
}
