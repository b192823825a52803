// Every rule on what happens between two steps, at its edge: a scene in which one condition of a
// proof fails, and no other. The plan must keep the effect; the rule with that one condition
// weakened would leave it out; and an exact argument or a plain simulation shows that the answer
// would be wrong then. With each comes a scene on the other side of the edge, where the effect is
// off by proof.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/plan/plan.hpp>
#include <contact/plan/plan_costs.hpp>
#include <contact/quaternion.hpp>
#include <contact/scene/scene_runs.hpp>
#include <contact/scene/scene_solids.hpp>

#include "plan_at_edge.hpp"
#include "plan_scenes.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

using contact::Decision;
using contact::Effect;
using contact::Scene;
using oracle::exact;
using oracle::Rational;
using oracle::Vector;
using plan_scenes::at_edge;
using plan_scenes::ball;
using plan_scenes::box;
using plan_scenes::dropped;
using plan_scenes::empty;
using plan_scenes::flight;
using plan_scenes::off;
using plan_scenes::Point;
using plan_scenes::stepped;
using plan_scenes::wall;

namespace {

/// A ball that flies head-on at a fixed ball; the ends of a step are symmetric to it. Both have
/// radius ¼: tunnelling takes more than twice ½ m in a step.
Scene shot(double speed, double h) {
  Scene scene = empty(0.5, 0, 4 * h, 1e9);
  ball(scene, 0.25, 1, {-1.5 * speed * h, 0, 0}, {speed, 0, 0});
  ball(scene, 0.25, 0, Point::Zero());
  return scene;
}

/// Whether two balls of a scene touch at the end of any step, exactly.
bool seen_at_steps(const Scene& scene, const Rational& h, int steps, const Rational& reach) {
  for (int k = 0; k <= steps; ++k) {
    const Vector d =
        flight(scene, 0, k * h) -
        (scene.bodies[1].moves ? flight(scene, 1, k * h) : exact(scene.bodies[1].position));
    if (d.dot(d) <= reach * reach) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("tunnelling: a step of twice the thickness is too long, a little less is not") {
  const double h = 0.25;
  const Rational reach = Rational(1) / 2;
  // Its late hits have no bound in this scene (hits on fixed balls are not counted), so the first
  // condition is tested by itself.
  const auto passing = [&](double speed) {
    const Decision decision =
        plan_scenes::decision(shot(speed, h), Effect::continuous_detection, stepped(h));
    return decision.tried.at(1).conditions.at(0);
  };
  const double fast = 4 * (1 + 1e-6);
  CHECK_FALSE(contact::holds(passing(fast)));
  CHECK_FALSE(seen_at_steps(shot(fast, h), exact(h), 4, reach));
  CHECK(contact::holds(passing(4 * (1 - 1e-6))));
  CHECK(seen_at_steps(shot(4 * (1 - 1e-6), h), exact(h), 4, reach));
  CHECK(passing(4).right == 1 * (1 - 128 * 0x1p-53));
  CHECK(passing(3).left >= 0.75);
}

TEST_CASE("tunnelling: both moving bodies count") {
  const double h = 0.25;
  Scene scene = empty(0.5, 0, 1, 1e9);
  ball(scene, 0.25, 1, {-1.125, 0, 0}, {3, 0, 0});
  ball(scene, 0.25, 1, {1.125, 0, 0}, {-3, 0, 0});
  // Each moves by 0.75 < 1, and both together by 1.5.
  at_edge(scene, Effect::continuous_detection, 1, 0, stepped(h));
  CHECK_FALSE(seen_at_steps(scene, exact(h), 4, Rational(1) / 2));
}

TEST_CASE("tunnelling: acceleration counts") {
  const double h = 0.25;
  Scene scene = empty(0.5, 0, 1.25, 1e9);
  scene.gravity = {0, 0, -8};
  ball(scene, 0.25, 1, {0, 0, 0.375 * 8 * 0.375}, {0, 0, 0});
  ball(scene, 0.25, 0, {0, 0, -4});
  // It falls from 1.125 at rest; between t = 0.75 and 1.25 it passes the other.
  const Decision decision = plan_scenes::decision(scene, Effect::continuous_detection, stepped(h));
  CHECK(decision.on);
  CHECK_FALSE(contact::holds(decision.tried.at(1).conditions.at(0)));
  const double at_rest = std::sqrt(scene.bodies[0].velocity.squaredNorm()) * h;
  CHECK(at_rest < 1);  // by the initial speed alone
  CHECK_FALSE(seen_at_steps(scene, exact(h), 5, Rational(1) / 2));
  const Vector end = flight(scene, 0, exact(1.25));
  CHECK(end.z() < exact(-4.0) - Rational(1) / 2);  // it came out below
}

TEST_CASE("tunnelling: rotation counts") {
  const double h = 0.25;
  Scene scene = empty(0.5, 0, 1, 1e9);
  plan_scenes::add(scene, contact::CapsuleShape{0.05, 1}, 1, Point::Zero()).angular_velocity = {
      4, 0, 0};
  ball(scene, 0.05, 1e6, {0, -0.479425538604203, 0.8775825618903728});  // at the angle ½ rad
  const Decision decision = plan_scenes::decision(scene, Effect::continuous_detection, stepped(h));
  CHECK(decision.on);
  CHECK_FALSE(contact::holds(decision.tried.at(1).conditions.at(0)));
  // The rod's tip rotates by 1 rad a step: from ½ rad before the ball to ½ rad beyond.
  const auto distance = [&](double angle) {
    const Point axis = contact::matrix_of(contact::exponential<double>({angle, 0, 0})).col(2);
    const Point d = scene.bodies[1].position;
    const double along = std::clamp(d.dot(axis), -1.0, 1.0);
    const Point rest = d - axis * along;
    return std::sqrt(rest.dot(rest));
  };
  CHECK(distance(0) > 0.4);
  CHECK(distance(1) > 0.4);
  CHECK(distance(0.5) < 1e-12);
}

TEST_CASE("late hits: the tolerance decides on the error of one late step") {
  // 3 m/s without gravity, e = 1, h = ¼: up to 2 · 3 · ¼ = 1.5 m. The hit is 1 ms after a step.
  Scene scene = empty(1, 0, 1, 1.4);
  wall(scene, Point::UnitZ(), 0);
  ball(scene, 0.5, 1, {0, 0, 0.5 + 3 * 0.251}, {0, 0, -3});
  at_edge(scene, Effect::continuous_detection, 1, 1, stepped(0.25));
  const double noticed = 0.5;
  const double turned_at = 3 * 0.251 - 3 * noticed;  // below the floor, reversed there
  const double right = 3 * (1 - 0.251);
  CHECK(std::abs(turned_at + 3 * (1 - noticed) - right) > 1.4);
  scene.tolerance.position = 1.5 * (1 + 1e-9);
  off(scene, Effect::continuous_detection, stepped(0.25));
}

TEST_CASE("late hits: a ball that loses speed leaves a floor from too deep, for ever") {
  // It would rest, and sinks into the floor a little with each late bounce.
  Scene scene = dropped(0.0625, 2, 60, 1);
  scene.materials[0].friction = 0.25;
  scene.bodies[1].velocity.x() = 1;
  const Decision decision =
      plan_scenes::decision(scene, Effect::continuous_detection, stepped(1.0 / 64));
  CHECK(decision.on);
  CHECK(std::isinf(decision.tried.at(1).conditions.at(1).left));
  contact::PlanOptions blind = stepped(1.0 / 64);
  blind.overrides.without = {Effect::continuous_detection};
  const auto run = contact::scenes::make_run(scene, contact::plan_scene(scene, blind));
  run->advance(60);
  CHECK(run->position(1).z() < 0.45);
}

TEST_CASE(
    "late hits: in an oblique hit the normal changes, and the ball leaves in another direction") {
  // Head-on but for half a radius, and as late as possible: a test just before they touch.
  const double h = 1.0 / 64;
  Scene scene = empty(1, 0, 1, 1);
  const double apart = std::sqrt(0.75) + 1e-6;
  ball(scene, 0.5, 1, {-apart, 0.5, 0}, {4, 0, 0});
  ball(scene, 0.5, 1e9, Point::Zero());
  const auto end = [&](bool looks) {
    contact::PlanOptions options = stepped(h);
    (looks ? options.overrides.with : options.overrides.without) = {Effect::continuous_detection};
    const auto run = contact::scenes::make_run(scene, contact::plan_scene(scene, options));
    run->advance(1);
    return run->position(0);
  };
  const double off_by = (end(true) - end(false)).norm();
  const Decision decision = plan_scenes::decision(scene, Effect::continuous_detection, stepped(h));
  const double said = decision.tried.at(1).conditions.at(1).left;
  const double late = 2 * 4 * h;
  CAPTURE(off_by, said);
  CHECK(off_by <= said);
  CHECK(off_by > late + 4 * 2 * 4 * h / 2 * 0.5);  // more than a missed chord would cost
}

TEST_CASE("grazing hits: a chord shorter than a step is missed, which changes the path") {
  const double h = 0.25;
  const double chord = 0.99;
  const double aside = std::sqrt(1 - chord * chord / 4);
  Scene scene = empty(1, 0, 1, 2.5);
  // From one end of a step just before the chord to the next just after.
  ball(scene, 0.5, 1, {-0.5, aside, 0}, {4, 0, 0});
  ball(scene, 0.5, 1e6, Point::Zero());
  at_edge(scene, Effect::continuous_detection, 1, 1, stepped(h));
  CHECK_FALSE(seen_at_steps(scene, exact(h), 4, Rational(1)));
  const double along_normal = 4 * chord / 2;
  const double thrown = 2 * along_normal * (1 - (0.5 - chord / 2) / 4) * (1 - 1e-6);
  CHECK(thrown > 2.5);
}

TEST_CASE("grazing hits: a path that gravity bends away from a ceiling is charged as a late hit") {
  generators::Random random(31);
  for (int i = 0; i < 200; ++i) {
    const double e = random.chance(0.5) ? 1 : random.uniform(0, 1);
    const double g = random.uniform(1, 20);
    const double duration = random.uniform(0.1, 4);
    const double h = random.uniform(0.001, 0.2);
    Scene scene = empty(e, 0, duration, 1e9);
    scene.gravity = {0, 0, -g};
    wall(scene, -Point::UnitZ(), 0);
    // It gets at least near enough to touch.
    const double up = random.uniform(0.1, 4);
    ball(scene, 0.5, 1, {0, 0, -0.5 - random.uniform(0, up * up / (2 * g))}, {1, 0, up});
    if (random.chance(0.5)) wall(scene, Point::UnitZ(), -100);
    const Decision decision =
        plan_scenes::decision(scene, Effect::continuous_detection, stepped(h));
    if (!(decision.tried.at(0).conditions.at(0).left > 0)) continue;  // out of reach
    const auto& late = decision.tried.at(1).conditions.at(1);
    CAPTURE(i, late.left, h);
    // Missed, a dip of g h/2 leaves the ball off by this at the end.
    CHECK((1 + e) * (g * h / 2) * duration <= late.left);
  }
}

TEST_CASE("a floor has no other side, and boxes have edges") {
  const Decision floor =
      plan_scenes::decision(dropped(1, 2, 3, 1), Effect::continuous_detection, stepped(0.01));
  CHECK_FALSE(floor.on);
  CHECK(floor.because.at(0).left == 0);
  Scene boxes = empty(0.5, 0, 1, 1e9);
  box(boxes, {1, 1, 1}, 1, {-4, 0.1, 0}, {4, 0, 0});
  box(boxes, {1, 1, 1}, 1, Point::Zero());
  const Decision edges = plan_scenes::decision(boxes, Effect::continuous_detection, stepped(0.001));
  CHECK(edges.on);
  CHECK(contact::holds(edges.tried.at(1).conditions.at(0)));
  CHECK_FALSE(contact::holds(edges.tried.at(1).conditions.at(2)));
}

TEST_CASE("late hits: compliant contacts have no bound, on a wall or in flight") {
  // Detected a step late, a spring starts deep: it adds more speed than it should.
  const double h = 0.05;
  const auto thrown = [&](Scene& scene) {
    scene.materials[0].stiffness = 200;
    at_edge(scene, Effect::continuous_detection, 1, 1, stepped(h));
    const auto end = [&](bool looks) {
      contact::PlanOptions options = stepped(h);
      (looks ? options.overrides.with : options.overrides.without) = {Effect::continuous_detection};
      const auto run = contact::scenes::make_run(scene, contact::plan_scene(scene, options));
      run->advance(20);
      return run->position(1);
    };
    CHECK((end(true) - end(false)).norm() > *scene.tolerance.position);
  };
  // A hard wall may be hit late by v h once.
  Scene on_wall = empty(0, 0, 20, 0.06);
  wall(on_wall, Point::UnitX(), 0);
  ball(on_wall, 0.5, 1, {0.5 + 20 * h + 1e-6, 0, 0}, {-1, 0, 0});
  off(on_wall, Effect::continuous_detection, stepped(h));
  thrown(on_wall);
  // Two balls may be late by both paths, and in an oblique hit.
  Scene in_flight = empty(0, 0, 20, 0.3);
  ball(in_flight, 5, 1, {-10 - 20 * h - 1e-6, 0, 0}, {1, 0, 0});
  ball(in_flight, 5, 1, Point::Zero());
  off(in_flight, Effect::continuous_detection, stepped(h));
  thrown(in_flight);
}

TEST_CASE("late hits: a rotating rod is hit more than once") {
  // A heavy ball hits a rod off its centre. The rod turns over, and its other half hits back.
  Scene scene = empty(1, 0, 8, 1e9);
  ball(scene, 0.25, 100, {-0.5, 0, 1.2}, {1, 0, 0});
  box(scene, {0.05, 0.05, 2}, 1, Point::Zero());
  at_edge(scene, Effect::continuous_detection, 1, 1, stepped(0.001));
  const auto run = contact::scenes::make_run(scene, contact::plan_scene(scene));
  run->advance(8);
  CHECK(run->counts().hits >= 2);
  // A ball of the same mass is hit once.
  scene.bodies[1].shape = contact::BallShape{2};
  scene.bodies[1].inertia = contact::solid_inertia(scene.bodies[1].shape, 1);
  scene.bodies[0].position.x() = -2.5;
  off(scene, Effect::continuous_detection, stepped(0.001));
  const auto once = contact::scenes::make_run(scene, contact::plan_scene(scene));
  once->advance(8);
  CHECK(once->counts().hits == 1);
}

TEST_CASE("a path bends between two tests: a floor that is touched at its very end is met") {
  // 4 m in the second; in its last 64th gravity bends the path by g dt²/8 = 0.24 mm.
  const double bend = 8.0 / 64 / 64 / 8;
  for (const bool on_a_ball : {false, true}) {
    const auto falling = [&](double gap) {
      Scene scene = dropped(0.5, gap, 1);
      if (on_a_ball) {
        scene.bodies[0].shape = contact::BallShape{8};
        scene.bodies[0].position = {0, 0, -8};
      }
      return scene;
    };
    const Scene scene = falling(4 - bend / 2);
    const contact::Plan plan = contact::plan_scene(scene);
    CAPTURE(on_a_ball);
    CHECK(plan.pairs == 1);
    const auto run = contact::scenes::make_run(scene, plan);
    run->advance(1);
    CHECK(run->position(1).z() > 0.5);
    CHECK(contact::plan_scene(falling(4 + 1e-9)).pairs == 0);
  }
}
