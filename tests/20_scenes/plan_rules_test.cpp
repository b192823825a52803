// Every rule at its edge: a scene in which one condition of a proof fails, and no other. The plan
// must keep the effect; the rule with that one condition weakened would leave it out; and an exact
// argument or a plain simulation shows that the answer would be wrong then. Beside each stands a
// scene on the other side of the edge, where the effect is off by proof.
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/bouncing.hpp>
#include <contact/events/hard_sphere_compose.hpp>
#include <contact/events/hard_sphere_scene.hpp>
#include <contact/plan/plan.hpp>
#include <contact/plan/plan_bounds.hpp>
#include <contact/plan/plan_costs.hpp>
#include <contact/rotation.hpp>
#include <contact/scene/scene_runs.hpp>
#include <contact/scene/scene_solids.hpp>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "plan_at_edge.hpp"
#include "plan_scenes.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

using contact::Decision;
using contact::Effect;
using contact::Proof;
using contact::Relation;
using contact::Scene;
using oracle::exact;
using oracle::Rational;
using oracle::Vector;
using plan_scenes::at_edge;
using plan_scenes::ball;
using plan_scenes::box;
using plan_scenes::dropped;
using plan_scenes::empty;
using plan_scenes::free_ball;
using plan_scenes::off;
using plan_scenes::only_lacks;
using plan_scenes::Point;
using plan_scenes::stepped;
using plan_scenes::table;
using plan_scenes::wall;

namespace {

constexpr double least = std::numeric_limits<double>::denorm_min();

/// Where a free ball of a scene is after a time, exactly.
Vector flight(const Scene& scene, std::size_t i, const Rational& t) {
  const auto& body = scene.bodies[i];
  return oracle::ballistic(exact(body.position), exact(body.velocity), exact(scene.gravity), t);
}

}  // namespace

// ---------------------------------------------------------------- how bodies move

TEST_CASE("gravity: a fall within the tolerance is left out, and not one ulp more") {
  // ½ · 8 · ½² = 1 m.
  const double under = std::nextafter(1.0, 0);
  const Scene edge = free_ball(8, 0.5, under);
  at_edge(edge, Effect::gravity, 3, 1);
  const Rational fall = -flight(edge, 0, Rational(1) / 2).z();
  CHECK(fall > exact(under));
  const Scene within = free_ball(8, 0.5, 1 + 1e-9);
  off(within, Effect::gravity);
  CHECK(exact(plan_scenes::decision(within, Effect::gravity).error) >= fall);
  off(free_ball(0, 1000, 1e-9), Effect::gravity);
  // However weak, it moves a ball by half a metre in a thousand seconds.
  at_edge(free_ball(1e-6, 1000, 1e-3), Effect::gravity, 0, 0);
}

TEST_CASE("gravity: a fall within the tolerance still decides whether two balls meet") {
  Scene scene = empty(1, 0, 0.01, 1e-3);
  scene.gravity = {0, 0, -10};
  ball(scene, 1, 1, {-5, 0, 2 + 1e-4}, {1000, 0, 0});
  ball(scene, 1, 0, Point::Zero());
  at_edge(scene, Effect::gravity, 3, 0);
  const Vector with = flight(scene, 0, Rational(1) / 200);
  CHECK(with.dot(with) < 4);  // it touches the ball that it would miss
  CHECK(exact(scene.bodies[0].position.z()) > 2);
}

TEST_CASE("gravity: a level table cancels it for smooth balls that lie on it exactly") {
  off(table(), Effect::gravity);
  off(table(), Effect::third_dimension);
  off(table(), Effect::resting);

  const Scene rough = table(0x1p-40);
  at_edge(rough, Effect::gravity, 2, 2);
  CHECK(exact(0x1p-40) * exact(8.0) > 0);  // μ g slows a ball

  Scene above = table();
  above.bodies[1].position.z() = std::nextafter(0.5, 1);
  CHECK(plan_scenes::is_on(above, Effect::gravity));
  const Decision decision = plan_scenes::decision(above, Effect::gravity);
  CHECK_FALSE(contact::holds(decision.tried.at(2).conditions.at(0)));
  CHECK(exact(above.bodies[1].position.z()) - exact(0.5) > 0);  // there is room to fall

  Scene rising = table();
  rising.bodies[1].velocity.z() = least;
  at_edge(rising, Effect::gravity, 2, 4);

  Scene uneven = table();
  uneven.bodies[2].shape = contact::BallShape{0.75};
  uneven.bodies[2].position.z() = 0.75;
  at_edge(uneven, Effect::gravity, 2, 7);
  // The line of centres rises when they touch: the hit lifts the larger ball.
  CHECK(exact(0.75) - exact(0.5) != 0);

  Scene soft = table();
  soft.materials[0].stiffness = 1000;
  at_edge(soft, Effect::gravity, 2, 1);
}

TEST_CASE("rotation: one ulp of friction turns a ball, and a corner turns a box") {
  Scene smooth = dropped(0.5, 1, 5);
  smooth.bodies[1].velocity.x() = 3;
  off(smooth, Effect::rotation);

  Scene rough = smooth;
  rough.materials[0].friction = 0x1p-60;
  at_edge(rough, Effect::rotation, 0, 2);
  // It slides when it hits at 4 m/s: the impulse μ (1 + e) m v turns it by 5 μ (1 + e) v/(2 r).
  CHECK(exact(0x1p-60) * 5 * Rational(3) / 2 * 4 / (2 * Rational(1) / 2) > 0);

  Scene corner = empty(0.5, 0, 5, 1e-6);
  corner.gravity = {0, 0, -8};
  wall(corner, Point::UnitZ(), 0);
  box(corner, {1, 2, 3}, 1, {0, 0, 6}).orientation = contact::exponential<double>({0.3, 0, 0});
  at_edge(corner, Effect::rotation, 0, 0);
  // The lowest corner is not below the centre: r × n is not 0.
  const auto turn = contact::matrix_of(corner.bodies[1].orientation);
  const Point low = turn * Point(1, -2, -3);
  CHECK(std::abs(low.y()) > 0.1);

  Scene tumbling = empty(1, 0, 5, 1e-6);
  box(tumbling, {1, 2, 3}, 1, Point::Zero()).spin = {0, 0, least};
  at_edge(tumbling, Effect::rotation, 0, 1);
  tumbling.bodies[0].spin = Point::Zero();
  off(tumbling, Effect::rotation);

  // Flat on the floor two mirrors leave no room for spin.
  Scene flat = empty(0.5, 0.5, 5, 1e-6);
  flat.gravity = {0, 0, -8};
  wall(flat, Point::UnitZ(), 0);
  box(flat, {1, 2, 3}, 1, {0, 0, 6});
  off(flat, Effect::rotation);
  off(flat, Effect::friction);
}

TEST_CASE("the gyroscopic term: a box that is no cube tumbles, and within bounds does not") {
  const auto spinning = [](const Point& half, const Point& spin, double duration,
                           double tolerance) {
    Scene scene = empty(1, 0, duration, tolerance);
    box(scene, half, 1, Point::Zero()).spin = spin;
    return scene;
  };
  off(spinning({1, 1, 1}, {1, 2, 3}, 100, 1e-9), Effect::gyroscopic_term);
  off(spinning({1, 2, 3}, {0, 0, 3}, 100, 1e-9), Effect::gyroscopic_term);

  const Scene nearly = spinning({1, 1, 1 + 1e-12}, {1, 2, 3}, 1e9, 1e-3);
  at_edge(nearly, Effect::gyroscopic_term, 0, 0);
  const auto& inertia = nearly.bodies[0].inertia;
  CHECK((exact(inertia(2, 2)) - exact(inertia(1, 1))) * 2 * 3 != 0);  // of ω × I ω, about x

  // A tolerance below what the term does to a corner in 2 s, found by small steps.
  const Scene tumbling = spinning({1, 2, 3}, {1, 2, 3}, 2, 1e-3);
  at_edge(tumbling, Effect::gyroscopic_term, 2, 1);
  const auto& body = tumbling.bodies[0];
  const Point momentum = body.inertia * body.spin;
  contact::Rotor<double> turned;
  for (int k = 0; k < 2000; ++k)
    turned = contact::midpoint_step<double>(turned, momentum, body.inertia.diagonal(), 1e-3);
  const auto steady = contact::exponential<double>(body.spin * 2);
  const Point corner(1, 2, 3);
  const Point aside = contact::matrix_of(turned) * corner - contact::matrix_of(steady) * corner;
  const double off_by = std::sqrt(aside.dot(aside));
  CHECK(off_by > 1e-3);
  // Its bound holds, and with a tolerance above it the term is left out.
  const double bound =
      plan_scenes::decision(tumbling, Effect::gyroscopic_term).tried.at(2).conditions.at(1).left;
  CHECK(off_by <= bound);
  off(spinning({1, 2, 3}, {1, 2, 3}, 2, bound), Effect::gyroscopic_term);
}

TEST_CASE("the third dimension: one ulp of motion, of spin or of place leaves the plane") {
  Scene flat = empty(1, 0.5, 2, 1e-6);
  box(flat, {1, 2, 3}, 1, Point::Zero(), {1, 0.25, 0}).spin = {0, 0, 2};
  ball(flat, 0.5, 1, {5, 0, 0});
  off(flat, Effect::third_dimension);
  CHECK(plan_scenes::is_on(flat, Effect::second_dimension));

  Scene pulled = flat;
  pulled.gravity.z() = least;
  at_edge(pulled, Effect::third_dimension, 0, 0);
  Scene moving = flat;
  moving.bodies[1].velocity.z() = -least;
  at_edge(moving, Effect::third_dimension, 0, 1);
  Scene spinning = flat;
  spinning.bodies[0].spin.x() = least;
  at_edge(spinning, Effect::third_dimension, 0, 2);
  Scene askew = flat;
  askew.bodies[0].orientation = contact::exponential<double>({1e-9, 0, 0});
  at_edge(askew, Effect::third_dimension, 0, 3);
  CHECK(contact::matrix_of(askew.bodies[0].orientation)(2, 1) != 0);
  Scene above = flat;
  above.bodies[1].position.z() = least;
  at_edge(above, Effect::third_dimension, 0, 4);
  // Touching, the line of centres has a component along z: no rounding hides it.
  CHECK(exact(above.bodies[1].position.z()) != 0);
  Scene tilted = flat;
  const double slope = 0x1p-30;
  wall(tilted, {std::sqrt(1 - slope * slope), 0, slope}, -4);
  at_edge(tilted, Effect::third_dimension, 0, 3);
}

TEST_CASE("the second dimension: a ball that drops straight, and one that drifts by one ulp") {
  Scene straight = dropped(0.5, 2, 3);
  straight.materials[0].friction = 0.5;
  off(straight, Effect::second_dimension);
  off(straight, Effect::third_dimension);
  off(straight, Effect::friction);
  off(straight, Effect::rotation);

  Scene drifting = straight;
  drifting.bodies[1].velocity.x() = least;
  at_edge(drifting, Effect::second_dimension, 0, 1);
  off(drifting, Effect::third_dimension);
  // It slides when it touches, so friction acts, and turns it.
  CHECK(plan_scenes::is_on(drifting, Effect::friction));
  CHECK(plan_scenes::is_on(drifting, Effect::rotation));
}

// ---------------------------------------------------------------- contacts

TEST_CASE("friction: however small, it takes speed from what slides") {
  Scene sliding = dropped(0.5, 2, 3);
  sliding.bodies[1].velocity.x() = 1;
  off(sliding, Effect::friction);
  sliding.materials[0].friction = least;
  at_edge(sliding, Effect::friction, 0, 0);
  CHECK(exact(least) > 0);  // times (1 + e) v of the hit: not 0 without rounding
}

TEST_CASE("restitution: off only if nothing comes back") {
  off(dropped(0, 2, 3), Effect::restitution);
  at_edge(dropped(0x1p-60, 2, 3), Effect::restitution, 0, 0);
  CHECK(exact(0x1p-60) * 4 > 0);  // the speed after a hit at 4 m/s
  off(free_ball(8, 1, 1e-9), Effect::restitution);
}

TEST_CASE("penalty contact: off if nothing gives way that may be touched") {
  off(dropped(0.5, 2, 3), Effect::penalty_contact);
  Scene soft = dropped(0.5, 2, 3);
  soft.materials.push_back({"felt", 0.5, 0, 1e4, 1});
  off(soft, Effect::penalty_contact);  // nobody is made of it
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
  // Both hit at t = 1. One after the other, the order decides who leaves how: exactly.
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
  at_edge(face, Effect::several_contacts, 0, 1);  // four corners come down at once
}

TEST_CASE("resting: a ball that begins on the floor, and one that begins one ulp above it") {
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

TEST_CASE("resting: without gravity a rod that turns presses on what it pushes along") {
  Scene scene = empty(0, 0, 2, 1e-6);
  box(scene, {2, 0.1, 0.1}, 1e6, Point::Zero()).spin = {0, 0, 1};
  ball(scene, 0.1, 1, {0.5, 0.25, 0});
  at_edge(scene, Effect::resting, 0, 1);
  // It is hit at ½ m/s and leaves the rod's end at more than 2 m/s: pressed all the way.
  const auto run = contact::scenes::make_run(scene, contact::plan_scene(scene));
  run->advance(2);
  CHECK(run->velocity(1).norm() > 2);
  // What cannot turn presses nothing.
  scene.bodies[0].spin = Point::Zero();
  scene.bodies[1].position = {0, 0.25, 0};
  scene.bodies[1].velocity.y() = -1;
  off(scene, Effect::resting);
}

TEST_CASE("sleeping: what never rests never sleeps") {
  off(dropped(1, 2, 100), Effect::sleeping);
  Scene lying = dropped(1, 0, 100);
  off(lying, Effect::sleeping);  // a level table: gravity is cancelled, nothing presses
  lying.materials[0].friction = 0.25;
  CHECK(plan_scenes::is_on(lying, Effect::sleeping));
  CHECK(plan_scenes::is_on(dropped(0.5, 2, 100), Effect::sleeping));
  off(dropped(0.5, 2, 1), Effect::sleeping);
}

// ---------------------------------------------------------------- between two steps

namespace {

/// A ball that flies at a ball that stands still, head on; a step's end falls on both sides of it
/// alike. Both have radius ¼: passing takes more than twice ½ m in a step.
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

TEST_CASE("passing through: a step of twice the thickness is too long, a little less is not") {
  const double h = 0.25;
  const Rational reach = Rational(1) / 2;
  // Its late hits have no bound in this scene (nobody counts how often it hits what stands still),
  // so the first condition is looked at by itself.
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

TEST_CASE("passing through: both movers count") {
  const double h = 0.25;
  Scene scene = empty(0.5, 0, 1, 1e9);
  ball(scene, 0.25, 1, {-1.125, 0, 0}, {3, 0, 0});
  ball(scene, 0.25, 1, {1.125, 0, 0}, {-3, 0, 0});
  // Each moves by 0.75 < 1, and both together by 1.5.
  at_edge(scene, Effect::continuous_detection, 1, 0, stepped(h));
  CHECK_FALSE(seen_at_steps(scene, exact(h), 4, Rational(1) / 2));
}

TEST_CASE("passing through: acceleration counts") {
  const double h = 0.25;
  Scene scene = empty(0.5, 0, 1.25, 1e9);
  scene.gravity = {0, 0, -8};
  ball(scene, 0.25, 1, {0, 0, 0.375 * 8 * 0.375}, {0, 0, 0});
  ball(scene, 0.25, 0, {0, 0, -4});
  // It falls from 1.125 with no speed at first; between t = 0.75 and 1.25 it passes what it meets.
  const Decision decision = plan_scenes::decision(scene, Effect::continuous_detection, stepped(h));
  CHECK(decision.on);
  CHECK_FALSE(contact::holds(decision.tried.at(1).conditions.at(0)));
  const double at_rest = std::sqrt(scene.bodies[0].velocity.squaredNorm()) * h;
  CHECK(at_rest < 1);  // what the speed at the beginning alone says
  CHECK_FALSE(seen_at_steps(scene, exact(h), 5, Rational(1) / 2));
  const Vector end = flight(scene, 0, exact(1.25));
  CHECK(end.z() < exact(-4.0) - Rational(1) / 2);  // it came out below
}

TEST_CASE("passing through: spin counts") {
  const double h = 0.25;
  Scene scene = empty(0.5, 0, 1, 1e9);
  plan_scenes::add(scene, contact::CapsuleShape{0.05, 1}, 1, Point::Zero()).spin = {4, 0, 0};
  ball(scene, 0.05, 1e6, {0, -0.479425538604203, 0.8775825618903728});  // at the angle ½ rad
  const Decision decision = plan_scenes::decision(scene, Effect::continuous_detection, stepped(h));
  CHECK(decision.on);
  CHECK_FALSE(contact::holds(decision.tried.at(1).conditions.at(0)));
  // The rod's tip turns by 1 rad a step: it is ½ rad before the ball, then ½ rad beyond.
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

TEST_CASE("late hits: what one step of lateness costs is the tolerance's business") {
  // 3 m/s without gravity, e = 1, h = ¼: up to 2 · 3 · ¼ = 1.5 m. The hit is 1 ms after a step.
  Scene scene = empty(1, 0, 1, 1.4);
  wall(scene, Point::UnitZ(), 0);
  ball(scene, 0.5, 1, {0, 0, 0.5 + 3 * 0.251}, {0, 0, -3});
  at_edge(scene, Effect::continuous_detection, 1, 1, stepped(0.25));
  const double noticed = 0.5;
  const double turned_at = 3 * 0.251 - 3 * noticed;  // below the floor, turned back there
  const double right = 3 * (1 - 0.251);
  CHECK(std::abs(turned_at + 3 * (1 - noticed) - right) > 1.4);
  scene.tolerance.position = 1.5 * (1 + 1e-9);
  off(scene, Effect::continuous_detection, stepped(0.25));
}

TEST_CASE("late hits: a ball that loses speed leaves a floor from too deep, for ever") {
  // It would rest, and sinks into the floor a little with each bounce that comes late.
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

TEST_CASE("late hits: at a slant the normal is another, and the ball leaves another way") {
  // Head-on but for half a radius, and as late as can be: a look just before they touch.
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

TEST_CASE("grazing hits: a chord shorter than a step is missed, and throws a ball off") {
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

TEST_CASE("grazing hits: what gravity bends away from a ceiling is charged as a late hit") {
  generators::Random random(31);
  for (int i = 0; i < 200; ++i) {
    const double e = random.chance(0.5) ? 1 : random.uniform(0, 1);
    const double g = random.uniform(1, 20);
    const double duration = random.uniform(0.1, 4);
    const double h = random.uniform(0.001, 0.2);
    Scene scene = empty(e, 0, duration, 1e9);
    scene.gravity = {0, 0, -g};
    wall(scene, -Point::UnitZ(), 0);
    // It comes at least near enough to touch.
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

// ---------------------------------------------------------------- cost, digits and time

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
  // From event to event the run asks everybody as long as the plan says so.
  const auto most = static_cast<int>(contact::cost::most_asked_by_all);
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
  // All of them fly alike, so nobody meets anybody.
  const Decision alike = plan_scenes::decision(spread(200, 3), Effect::broad_phase);
  CHECK_FALSE(alike.on);
  CHECK(alike.because.at(0).left == 0);
}

TEST_CASE("float: not where the square of a time is none") {
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
  plan_scenes::box(die, {0.2, 0.25, 0.3}, 1, {5, 0, 1}).spin = {1, 2, 3};
  const contact::Plan plan = contact::plan_scene(die);
  CHECK(contact::decision_on(plan, Effect::horizon).on);
  CHECK_FALSE(contact::decision_on(plan, Effect::horizon).value);
  bool told = false;
  for (const std::string& notice : plan.notices)
    told = told || notice.find("is not known") != std::string::npos;
  CHECK(told);
}

TEST_CASE("the horizon: who is light is fast, however heavy the others are") {
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
  CHECK(horizon(gas) <= before);  // somebody heavy at rest makes nobody slower
  gas.bodies.back().velocity = {1, 0, 0};
  CHECK(horizon(gas) <= before / 50);
}

TEST_CASE("the horizon: nothing grows before the first hit, and that is when one may come") {
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
  // Both move: how fast they come together counts. A wall that is nearer comes first.
  near.bodies.back().velocity = {-3, 0, 0};
  CHECK(std::abs(first(near) - 2) < 1e-12);
  near.bodies.back().velocity = {4, 0, 0};
  CHECK(std::abs(first(near) - 188.5 / 4) < 1e-12);  // they part, and the far wall is next
  ball(near, 0.5, 1, {100, 1.5, 400}, {0, -1, 0});
  CHECK(std::abs(first(near) - 1) < 1e-12);
  // Gravity brings nobody together who falls, but all of them to what stands.
  near.gravity = {0, 0, -10};
  ball(near, 0.5, 1, {400, 400, 0.5 + 0.05});
  CHECK(std::abs(first(near) - 0.1) < 1e-9);
  // What touches may hit at once.
  ball(near, 0.5, 1, {401, 400, 0.5 + 0.05}, {-1, 0, 0});
  CHECK(first(near) == 0);
}

TEST_CASE("the horizon: a crowd is one, however far away somebody else is") {
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

TEST_CASE("the step: a crowd takes its hits late, however it looks for them") {
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
    // Each hits once, at 6 m/s, and its place is off by what it goes to the wall and back too late.
    CHECK(step.error == (count > 64 ? plan.error : 0));
    if (count > 64) {
      CHECK(step.error >= 2 * 6 * plan.step);
      CHECK(step.error <= 1);
      CHECK_FALSE(step.proven);
    }
  }
}

TEST_CASE("float: enough for a short flight, not for a place that it cannot hold") {
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
  // Beyond the last bounce there are infinitely many; only hops below a tolerance may be left out.
  const Scene zeno = dropped(0.5, 2, 10, 0);
  at_edge(zeno, Effect::event_driven, 1, 5);
  CHECK(std::isinf(contact::bounce_at<double>(bounces, 10).bounces));
  const Decision hops = plan_scenes::decision(dropped(0.5, 2, 10, 1e-6), Effect::event_driven);
  CHECK(hops.on);
  CHECK(hops.error > 0);
  CHECK(hops.error <= 1e-6);

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

TEST_CASE("the step follows from the tolerance, and a hit that is late by it stays inside") {
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

// ---------------------------------------------------------------- errors together

namespace {

/// A box that tumbles a little and falls a little, far from everything.
Scene tumbling_fall(double tolerance) {
  Scene scene = empty(1, 0, 0.5, tolerance);
  scene.gravity = {0, 0, -0x1p-10};
  box(scene, {1, 2, 3}, 1, {3, 2, 1}, {1, 0, 0}).spin = {0.00125, 0.0025, 0.00375};
  return scene;
}

/// The bounds of its three errors: aside, fall, rounding in float.
std::array<double, 3> errors_of_fall() {
  const contact::Plan plan = contact::plan_scene(tumbling_fall(1));
  return {contact::decision_on(plan, Effect::gyroscopic_term).error,
          contact::decision_on(plan, Effect::gravity).error,
          contact::decision_on(plan, Effect::double_precision).error};
}

}  // namespace

TEST_CASE("the tolerance holds for all errors together: each rule takes from what is left") {
  const auto [aside, fall, rounding] = errors_of_fall();
  REQUIRE(rounding < aside);
  REQUIRE(aside < fall);
  const auto left_out = [&](double tolerance) {
    const contact::Plan plan = contact::plan_scene(tumbling_fall(tolerance));
    CHECK(plan.tolerance == tolerance);
    CHECK(plan.error <= tolerance);
    std::vector<Effect> effects;
    Rational sum = 0;
    for (const Decision& decision : plan.decisions) {
      if (!(decision.error > 0)) continue;
      effects.push_back(decision.effect);
      sum += exact(decision.error);
    }
    CHECK(sum <= exact(tolerance));
    CHECK(abs(sum - exact(plan.error)) <= exact(plan.error * 0x1p-50));
    return effects;
  };
  using Effects = std::vector<Effect>;
  const double little = 1e-12;
  CHECK(left_out((aside + fall + rounding) * (1 + little)) ==
        Effects{Effect::gravity, Effect::gyroscopic_term, Effect::double_precision});
  // Each fits by itself, and any two, but not all three: float was asked last.
  CHECK(left_out((aside + fall + rounding) * (1 - little)) ==
        Effects{Effect::gravity, Effect::gyroscopic_term});
  // What is left after the gyroscopic term is less than the fall, and enough for float.
  CHECK(left_out((aside + fall) * (1 - little)) ==
        Effects{Effect::gyroscopic_term, Effect::double_precision});
  CHECK(left_out((aside + rounding) * (1 - little)) == Effects{Effect::gyroscopic_term});
  // Where a spin changes float has no bound.
  CHECK(left_out(aside * (1 - little)).empty());
  const Decision gravity =
      plan_scenes::decision(tumbling_fall((aside + fall) * (1 - little)), Effect::gravity);
  CHECK(gravity.tried.back().conditions.at(1).right_is == "what is left of the tolerance");
  CHECK(only_lacks(gravity, gravity.tried.size() - 1, 1));
}

TEST_CASE("the errors of a run in steps share the tolerance: hops a half, sleep a half") {
  Scene scene = dropped(0.5, 2, 10, 1e-4);
  scene.materials[0].friction = 0.5;
  scene.bodies[1].velocity.x() = 1;
  const contact::Plan plan = contact::plan_scene(scene);
  const Decision& resting = contact::decision_on(plan, Effect::resting);
  const Decision& sleeping = contact::decision_on(plan, Effect::sleeping);
  REQUIRE(resting.on);
  REQUIRE(sleeping.on);
  // Hops of half the tolerance do not happen: what leaves at e v rises e² of that.
  CHECK(plan.rest_height == 0.5e-4);
  CHECK(contact::holds(resting.because.back()));
  CHECK(std::abs(resting.because.back().left / 0.125e-4 - 1) <= 1e-12);
  CHECK(std::abs(plan.sleep_speed * 10 * 10 / 0.5 / 0.5e-4 - 1) <= 1e-12);
  // The ball rubs while it lies, so its way depends on when it lies: no number is a bound.
  CHECK(std::isinf(resting.error));
  CHECK(std::isinf(sleeping.error));
  CHECK(std::isinf(plan.error));
  // Smooth, it moves along its floor as if it hopped.
  Scene smooth = scene;
  smooth.materials[0].friction = 0;
  const contact::Plan gliding = contact::plan_scene(smooth, stepped(0.01));
  CHECK(contact::decision_on(gliding, Effect::resting).error == resting.because.back().left);
  CHECK(contact::decision_on(gliding, Effect::sleeping).error == 0.5e-4);
  CHECK(gliding.error > 0.6e-4);
  CHECK(gliding.error <= 1e-4);
  // A step is shorter than that hop: then hops that fit into one are left out, g h²/8 high.
  const contact::Plan fine = contact::plan_scene(smooth, stepped(1e-4));
  CHECK(std::abs(contact::decision_on(fine, Effect::resting).error / 0.25e-8 - 1) <= 1e-12);
  // Nothing comes back, so nothing hops.
  scene.materials[0].restitution = 0;
  CHECK(plan_scenes::decision(scene, Effect::resting).error == 0);
  // What never rests bounces however slow it is.
  CHECK(contact::plan_scene(dropped(1, 2, 3), stepped(0.01)).rest_height == 0);
  // No error of a place is allowed: hops that rounding hides, and no sleep of what moves.
  scene = dropped(0.5, 2, 10, 0);
  scene.materials[0].friction = 0.5;
  const contact::Plan strict = contact::plan_scene(scene);
  CHECK(strict.error == 0);
  CHECK(strict.sleep_speed == 0);
  CHECK(strict.rest_height > 0);
  CHECK(strict.rest_height <= 2.5 * 0x1p-53 * (1 + 1e-12));
}

TEST_CASE("hops that steps leave out have a bound where a smooth ball lies alone, and only there") {
  const auto error = [](const Scene& scene) {
    return plan_scenes::decision(scene, Effect::resting, stepped(0.01)).error;
  };
  const auto sleeping = [](const Scene& scene) {
    return plan_scenes::decision(scene, Effect::sleeping, stepped(0.01)).error;
  };
  const double endless = std::numeric_limits<double>::infinity();
  const Scene alone = dropped(0.5, 2, 10, 1e-4);
  const double hop = error(alone);
  CHECK(hop > 0);
  CHECK(hop <= 0.125e-4 * (1 + 1e-12));
  // A wall at right angles, however the ball hits it, changes nothing along the floor's normal.
  Scene walled = alone;
  wall(walled, Point::UnitX(), -5);
  CHECK(error(walled) == hop);
  CHECK(sleeping(walled) == 0.5e-4);
  // At a slant it does, from below as from above; so does a rough one, and a second ball.
  for (const Point& slant : {Point(0.6, 0, 0.8), Point(0.6, 0, -0.8)}) {
    Scene wedge = alone;
    wall(wedge, slant, -5);
    CHECK(error(wedge) == endless);
    CHECK(sleeping(wedge) == endless);
  }
  Scene rough = walled;
  rough.materials[0].friction = 0.5;
  CHECK(error(rough) == endless);
  Scene two = alone;
  ball(two, 0.5, 1, {3, 0, 2}, {-1, 0, 0});
  CHECK(error(two) == endless);
  CHECK(std::isinf(contact::plan_scene(two, stepped(0.01)).error));
  // Without a floor nothing lies on anything: nothing is left out, and nothing sleeps.
  Scene falling = two;
  falling.bodies.erase(falling.bodies.begin());
  ball(falling, 0.5, 1, {-3, 0, 2}, {1, 0, 0});
  const auto plan = contact::plan_scene(falling, stepped(0.01));
  CHECK(contact::decision_on(plan, Effect::resting).on);
  CHECK(plan.rest_height == 0);
  CHECK(plan.sleep_speed == 0);
  CHECK(plan.error == 0);
  // Between walls that stand upright neither.
  Scene shaft = alone;
  std::get<contact::HalfSpaceShape>(shaft.bodies[0].shape) = {Point::UnitX(), -5};
  CHECK(error(shaft) == 0);
}

TEST_CASE("an override changes the sum: none is accepted, or there is no bound") {
  const auto [aside, fall, rounding] = errors_of_fall();
  const Scene scene = tumbling_fall(1);
  contact::PlanOptions options;
  options.overrides.with = {Effect::gravity};
  const double rest = contact::plan_scene(scene, options).error;
  CHECK(std::abs(rest - (aside + rounding)) <= 0x1p-50 * rest);
  options.overrides.with.clear();
  options.overrides.without = {Effect::rotation};
  CHECK(std::isinf(contact::plan_scene(scene, options).error));
  // To leave bodies awake, or to go in steps, makes no error.
  options.overrides.without = {Effect::sleeping, Effect::event_driven, Effect::broad_phase};
  CHECK(contact::plan_scene(scene, options).error <= 1);
}

// ---------------------------------------------------------------- overriding

TEST_CASE("an override has the last word, and both are kept") {
  contact::PlanOptions options;
  options.overrides.with = {Effect::rotation};
  options.overrides.without = {Effect::gravity};
  const contact::Plan plan = contact::plan_scene(dropped(0.5, 2, 3), options);
  const Decision& rotation = contact::decision_on(plan, Effect::rotation);
  CHECK(rotation.on);
  CHECK_FALSE(rotation.planned);
  CHECK(rotation.overridden);
  const Decision& gravity = contact::decision_on(plan, Effect::gravity);
  CHECK_FALSE(gravity.on);
  CHECK(gravity.planned);
  bool said = false;
  for (const std::string& notice : plan.notices)
    said = said || notice.find("Without gravity") != std::string::npos;
  CHECK(said);
  CHECK_FALSE(contact::decision_on(plan, Effect::friction).overridden);

  options.overrides.with = {Effect::horizon};
  CHECK_THROWS_AS(contact::plan_scene(dropped(0.5, 2, 3), options), std::invalid_argument);
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    CHECK_THROWS_AS(contact::plan_scene(dropped(0.5, 2, 3), stepped(bad)), std::invalid_argument);
}

TEST_CASE("gravity: a table cancels it only from below, and only if nothing pushes up from it") {
  // Two balls that hang at a ceiling, and fall.
  Scene hanging = empty(1, 0, 2, 1e-6);
  hanging.gravity = {0, 0, -8};
  wall(hanging, -Point::UnitZ(), 0);
  ball(hanging, 0.5, 1, {0, 0, -0.5}, {1, 0, 0});
  CHECK(plan_scenes::is_on(hanging, Effect::gravity));
  // A wall that leans throws what meets it up.
  Scene ramp = table();
  off(ramp, Effect::gravity);
  wall(ramp, Point(-0.6, 0, 0.8), -1.5);
  at_edge(ramp, Effect::gravity, 2, 6);
}

TEST_CASE("the third dimension: a box that does not span the plane is met at an edge") {
  Scene scene = empty(1, 0, 2, 1e-6);
  ball(scene, 0.5, 1, {0, 0, 0}, {2, 0.25, 0});
  box(scene, {0.5, 2, 0.75}, 0, {2, 0, 0.5});
  off(scene, Effect::third_dimension);
  scene.bodies[1].shape = contact::BoxShape{{0.5, 2, 0.25}};
  at_edge(scene, Effect::third_dimension, 0, 4);
  // Its edge is at z = 1/4, so the normal there points down by asin(1/2).
  const auto run = contact::scenes::make_run(scene, contact::plan_scene(scene));
  run->advance(2);
  CHECK(run->velocity(0).z() < -0.1);
}

TEST_CASE("from event to event: what stands still is a half-space or a ball") {
  Scene scene = empty(1, 0, 2, 1e-6);
  ball(scene, 0.5, 1, {0, 0, 0}, {2, 0.25, 0});
  box(scene, {0.5, 2, 0.75}, 0, {2, 0, 0.5});
  at_edge(scene, Effect::event_driven, 0, 1);
}

TEST_CASE("a switch that changes nothing in the run is told") {
  const auto told = [](const Scene& scene, const contact::PlanOptions& options) {
    std::string all;
    for (const std::string& notice : contact::plan_scene(scene, options).notices) all += notice;
    return all;
  };
  const auto idle = "Forced, but changes nothing in this run: ";
  contact::PlanOptions without;
  without.overrides.without = {Effect::continuous_detection};
  CHECK(told(table(), without).starts_with(idle + std::string("continuous-detection. Without")));
  CHECK(told(table(), without).find("no bound") == std::string::npos);
  contact::PlanOptions with;
  with.overrides.with = {Effect::rotation, Effect::third_dimension};
  CHECK(told(table(), with).starts_with(idle + std::string("rotation, third-dimension. ")));
  // In steps these are stages, or coordinates.
  with.step = without.step = 0.01;
  CHECK(told(table(), with).find(idle) == std::string::npos);
  CHECK(told(table(), without).find(idle) == std::string::npos);
  contact::PlanOptions in_float;
  in_float.step = 0.01;
  in_float.overrides.without = {Effect::double_precision};
  CHECK(told(table(), in_float).find(idle + std::string("double-precision.")) != std::string::npos);
}

TEST_CASE("every effect has a decision in its place, and a name that leads back to it") {
  const contact::Plan plan = contact::plan_scene(table());
  REQUIRE(plan.decisions.size() == contact::all_effects.size());
  for (std::size_t i = 0; i < plan.decisions.size(); ++i) {
    CHECK(plan.decisions[i].effect == contact::all_effects[i]);
    CHECK(contact::effect_named(contact::effect_name(plan.decisions[i].effect)) ==
          plan.decisions[i].effect);
    CHECK_FALSE(plan.decisions[i].why.empty());
    for (const auto& condition : plan.decisions[i].because) {
      CHECK_FALSE(condition.left_is.empty());
      CHECK_FALSE(condition.right_is.empty());
    }
  }
  CHECK_FALSE(contact::effect_named("gravitas"));
}

TEST_CASE("a scene in which nothing moves needs nothing") {
  Scene scene = empty(0.5, 0.5, 1, 1e-6);
  scene.gravity = {0, 0, -8};
  wall(scene, Point::UnitZ(), 0);
  const contact::Plan plan = contact::plan_scene(scene);
  for (const Decision& decision : plan.decisions) {
    if (decision.effect == Effect::event_driven) continue;
    INFO(contact::effect_name(decision.effect));
    CHECK_FALSE(decision.on);
  }
}

TEST_CASE("who asks for the order of events allows no error of a place") {
  // The second one comes down a hundredth of a second earlier, in the same step.
  Scene scene = plan_scenes::empty(1, 0.5, 0.6, 0.5);
  scene.gravity = {0, 0, -9.8125};
  plan_scenes::wall(scene, {0, 0, 1}, 0);
  plan_scenes::ball(scene, 0.5, 1, {0, 0, 1.03125}, {1, 0, 0});
  plan_scenes::ball(scene, 0.5, 1, {1000, 0, 1}, {1, 0, 0});
  REQUIRE_FALSE(plan_scenes::is_on(scene, Effect::continuous_detection));
  scene.tolerance.event_order = true;
  CHECK(plan_scenes::is_on(scene, Effect::continuous_detection));
}

TEST_CASE("resting: an elastic box may rest on a floor, where an elastic ball may not") {
  Scene elastic = dropped(1, 2, 60);
  off(elastic, Effect::resting);
  elastic.bodies[1].shape = contact::BoxShape{{0.5, 0.5, 0.5}};
  CHECK(plan_scenes::is_on(elastic, Effect::resting));
}

TEST_CASE("the gyroscopic term: its bound is for what touches nothing") {
  Scene scene = empty(1, 0, 2, 1e3);
  box(scene, {1, 2, 3}, 1, Point::Zero()).spin = {1, 2, 3};
  off(scene, Effect::gyroscopic_term);
  wall(scene, Point::UnitX(), -3);
  at_edge(scene, Effect::gyroscopic_term, 2, 0);
}

TEST_CASE("from event to event: only what a formula takes from one event to the next") {
  // Without gravity, and elastic: a box that meets a wall.
  Scene corners = empty(1, 0, 10, 1e-6);
  wall(corners, Point::UnitX(), -2);
  box(corners, {0.5, 0.5, 0.5}, 1, Point::Zero(), {-1, 0, 0});
  at_edge(corners, Effect::event_driven, 0, 0);
  // A box that turns over and meets nothing.
  Scene tumbling = empty(1, 0, 2, 1e-6);
  box(tumbling, {1, 2, 3}, 1, Point::Zero()).spin = {1, 2, 3};
  at_edge(tumbling, Effect::event_driven, 0, 4);
}

TEST_CASE("hops are left out on one floor, for a tolerance, and where nothing else is hit") {
  off(dropped(0.5, 2, 10), Effect::event_driven);
  Scene corner = dropped(0.5, 2, 10);
  wall(corner, Point::UnitX(), -1);
  corner.bodies[1].velocity.x() = -1;
  at_edge(corner, Effect::event_driven, 2, 5);
  at_edge(dropped(0.5, 2, 10, 0), Effect::event_driven, 2, 7);

  // On a ball that stands still, aside of its top: no place to rest, but a slope to leave by.
  Scene slope = dropped(0.5, 2, 10);
  slope.bodies[0].shape = contact::BallShape{0.5};
  slope.bodies[0].position = {0.1, 0, -0.5};
  at_edge(slope, Effect::event_driven, 2, 6);
  CHECK(8 * 0.1 / 2 * 1 * 1 > 1e4 * *slope.tolerance.position);  // ½ g sin α t² after a second

  // So little gravity that the longest hop that might be left out has no finite height.
  Scene drifting = dropped(0.5, 0, 1e30, 1e30);
  drifting.gravity = {0, 0, -1e-280};
  drifting.bodies[1].velocity.z() = -1e-250;
  at_edge(drifting, Effect::event_driven, 2, 8);
}

TEST_CASE("a step is at most a tenth of what a spring's frequency asks for") {
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

TEST_CASE("parts of springs: from the tolerance, unless something rubs or is damped") {
  const auto soft = [](double tolerance) {
    Scene scene = dropped(0.5, 0.5, 2, tolerance);
    scene.materials[0].stiffness = 2000;
    return scene;
  };
  const auto notice_of = [](const contact::Plan& plan) {
    for (const std::string& notice : plan.notices)
      if (notice.starts_with("Springs push in parts of ")) return notice;
    return std::string();
  };
  const double swing = std::sqrt(1000.0);  // two equal springs in a row
  const contact::Plan plan = contact::plan_scene(soft(1e-3));
  const Decision& springs = contact::decision_on(plan, Effect::penalty_contact);
  // Half of the tolerance: v T (ω p)² (1/24 + (1 + ω T/π)/8).
  const double part = plan.spring_part;
  const double contacts = 1 + swing * 2 / 3.141592653589793;
  const double speed = contact::scene_bounds(soft(1e-3)).pairs[0].closing;
  const double off = speed * 2 * std::pow(swing * part, 2) * (1.0 / 24 + contacts / 8);
  CHECK(std::abs(off / 0.5e-3 - 1) <= 1e-9);
  CHECK(std::abs(springs.error / off - 1) <= 1e-9);
  CHECK(springs.because.back().right == 1e-3);
  CHECK(notice_of(plan).find("by an estimate that keeps the tolerance") != std::string::npos);
  // A hundredth of the error for a tenth of the length. (What is late dips by the tolerance, and is
  // faster for that, by a little.)
  CHECK(std::abs(contact::plan_scene(soft(1e-5)).spring_part / part - 0.1) <= 1e-3);
  // As long as they are for energy's sake.
  const auto is_longest = [&](double length) {
    return std::abs(length * 128 * swing - 1) <= 1e-12;
  };
  CHECK(is_longest(contact::plan_scene(soft(10)).spring_part));
  CHECK(contact::plan_scene(soft(10)).error < 1);

  // More than a thousand a step, no error of a place, a damper, friction: nothing is claimed.
  const auto unclaimed = [&](const Scene& scene, const std::string& why) {
    const contact::Plan other = contact::plan_scene(scene);
    const Decision& decision = contact::decision_on(other, Effect::penalty_contact);
    CHECK(is_longest(other.spring_part));
    CHECK(decision.error == 0);
    CHECK_FALSE(contact::holds(decision.because.back()));
    CHECK_FALSE(contact::decision_on(other, Effect::step_size).proven);
    CHECK(notice_of(other).find(why) != std::string::npos);
  };
  unclaimed(soft(1e-12), "more than 1024 parts a step");
  unclaimed(soft(0), "no error is accepted");
  Scene damped = soft(1e-3);
  damped.materials[0].damping = least;
  unclaimed(damped, "rubs, or is damped");
  Scene rough = soft(1e-3);
  rough.materials[0].friction = least;
  unclaimed(rough, "rubs, or is damped");
  // Its damper slows it by what the part's end says: of first order.
  const auto height = [](double shorter) {
    Scene scene = dropped(0.5, 0.5, 1.2, 1e-3);
    scene.materials[0].stiffness = 2000;
    scene.materials[0].damping = 2;
    contact::Plan made = contact::plan_scene(scene);
    made.spring_part /= shorter;
    const auto run = contact::scenes::make_run(scene, made);
    run->advance(1.2);
    return run->position(1).z();
  };
  const double right = height(256);
  const double ratio = (height(4) - right) / (height(8) - right);
  CHECK(ratio > 1.9);
  CHECK(ratio < 2.3);
}

// ---------------------------------------------------------------- what meets whom, and how often

namespace {

/// More balls than are asked one by one, in rows of `row`, in the plane of x and y; the last comes
/// back at the one before it.
Scene crowd(int row) {
  Scene scene = empty(1, 0, 0.5, 1e-6);
  for (int i = 0; i < 300; ++i) ball(scene, 0.25, 1, {1.0 * (i % row), 1.0 * (i / row), 0});
  scene.bodies.back().velocity.x() = -2;
  return scene;
}

}  // namespace

TEST_CASE("a crowd lies in a plane if each of its balls does, and what stands still among it") {
  off(crowd(20), Effect::third_dimension);
  off(crowd(300), Effect::second_dimension);

  for (const int row : {20, 300}) {
    Scene lifted = crowd(row);
    lifted.bodies.back().position.z() = least;
    // What is on a line has another plane.
    if (row == 20)
      at_edge(lifted, Effect::third_dimension, 0, 4);
    else
      at_edge(lifted, Effect::second_dimension, 2, 9);
    lifted.bodies.back().position.z() = 0.01;
    // The line of centres rises: the hit lifts it.
    const auto run = contact::scenes::make_run(lifted, contact::plan_scene(lifted));
    run->advance(0.5);
    CHECK(run->velocity(299).z() > 0.01);
  }
  // On a line: aside of it, in the plane.
  Scene aside = crowd(300);
  aside.bodies[150].position.y() = least;
  off(aside, Effect::third_dimension);
  at_edge(aside, Effect::second_dimension, 2, 4);

  // A ball that stands still above the plane, and a box that ends below it.
  Scene post = crowd(20);
  ball(post, 0.25, 0, {18.5, 14.5, 0});
  off(post, Effect::third_dimension);
  post.bodies.back().position.z() = least;
  at_edge(post, Effect::third_dimension, 0, 4);
  Scene step = crowd(20);
  box(step, {1, 1, 1}, 0, {30, 0, -0.75});
  off(step, Effect::third_dimension);
  step.bodies.back().position.z() = -1.125;
  at_edge(step, Effect::third_dimension, 0, 4);
}

TEST_CASE("late hits: what gives way has no bound, on a wall or in flight") {
  // Noticed a step late, a spring begins deep: it gives more speed than it takes.
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
  // Two balls may be late by both ways, and at a slant.
  Scene in_flight = empty(0, 0, 20, 0.3);
  ball(in_flight, 5, 1, {-10 - 20 * h - 1e-6, 0, 0}, {1, 0, 0});
  ball(in_flight, 5, 1, Point::Zero());
  off(in_flight, Effect::continuous_detection, stepped(h));
  thrown(in_flight);
}

TEST_CASE("late hits: a rod that turns is hit more than once") {
  // A heavy ball hits a rod aside of its middle. The rod turns over, and its other half hits back.
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

TEST_CASE("resting: a ball that begins an ulp too deep need not come out of the floor") {
  Scene deep = dropped(1 - 0x1p-40, 0, 100);
  deep.bodies[1].position.z() = std::nextafter(0.5, 0);
  deep.bodies[1].velocity.z() = 1e-9;
  at_edge(deep, Effect::resting, 3, 0);
  // Gravity takes all of its speed on less than an ulp: it presses on the floor for ever.
  const Rational depth = exact(0.5) - exact(deep.bodies[1].position.z());
  CHECK(exact(1e-9) * exact(1e-9) < 2 * 8 * depth);
  deep.bodies[1].position.z() = 0.5;
  off(deep, Effect::resting);
}

TEST_CASE("spin is energy where something rubs") {
  // At rest but for its spin; 4 m on there is another ball.
  Scene scene = empty(0, 0.5, 3, 1e-6);
  scene.gravity = {0, 0, -8};
  wall(scene, Point::UnitZ(), 0);
  ball(scene, 0.5, 1, {0, 0, 0.5}).spin = {0, 100, 0};
  ball(scene, 0.5, 1, {5, 0, 0.5});
  const contact::Plan plan = contact::plan_scene(scene);
  CHECK(plan.pairs == 3);
  CHECK(contact::decision_on(plan, Effect::several_contacts).on);
  const auto run = contact::scenes::make_run(scene, plan);
  run->advance(3);
  CHECK(run->position(2).x() > 5.5);
  // Smooth, it spins where it is, and nobody meets anybody but the floor.
  scene.materials[0].friction = 0;
  CHECK(contact::plan_scene(scene).pairs == 2);
}

TEST_CASE("a path bends between two looks: a floor that is touched in its last moment is met") {
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
