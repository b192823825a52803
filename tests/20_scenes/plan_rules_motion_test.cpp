// Every rule of motion, at its edge: a scene in which one condition of a proof fails, and no other.
// The plan must keep the effect; the rule with that one condition weakened would leave it out; and
// an exact argument or a plain simulation shows that the answer would be wrong then. With each
// comes a scene on the other side of the edge, where the effect is off by proof.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/plan/plan.hpp>
#include <contact/plan/plan_costs.hpp>
#include <contact/quaternion.hpp>
#include <contact/rotation.hpp>
#include <contact/scene/scene_runs.hpp>

#include "plan_at_edge.hpp"
#include "plan_scenes.hpp"
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
using plan_scenes::crowd;
using plan_scenes::dropped;
using plan_scenes::empty;
using plan_scenes::flight;
using plan_scenes::free_ball;
using plan_scenes::least;
using plan_scenes::off;
using plan_scenes::Point;
using plan_scenes::table;
using plan_scenes::wall;

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
  // It slides when it hits at 4 m/s: the impulse μ (1 + e) m v changes its angular velocity by 5 μ
  // (1 + e) v/(2 r).
  CHECK(exact(0x1p-60) * 5 * Rational(3) / 2 * 4 / (2 * Rational(1) / 2) > 0);

  Scene corner = empty(0.5, 0, 5, 1e-6);
  corner.gravity = {0, 0, -8};
  wall(corner, Point::UnitZ(), 0);
  box(corner, {1, 2, 3}, 1, {0, 0, 6}).orientation = contact::exponential<double>({0.3, 0, 0});
  at_edge(corner, Effect::rotation, 0, 0);
  // The lowest vertex is not below the centre: r × n is not 0.
  const auto turn = contact::matrix_of(corner.bodies[1].orientation);
  const Point low = turn * Point(1, -2, -3);
  CHECK(std::abs(low.y()) > 0.1);

  Scene tumbling = empty(1, 0, 5, 1e-6);
  box(tumbling, {1, 2, 3}, 1, Point::Zero()).angular_velocity = {0, 0, least};
  at_edge(tumbling, Effect::rotation, 0, 1);
  tumbling.bodies[0].angular_velocity = Point::Zero();
  off(tumbling, Effect::rotation);

  // Flat on the floor two mirrors exclude rotation.
  Scene flat = empty(0.5, 0.5, 5, 1e-6);
  flat.gravity = {0, 0, -8};
  wall(flat, Point::UnitZ(), 0);
  box(flat, {1, 2, 3}, 1, {0, 0, 6});
  off(flat, Effect::rotation);
  off(flat, Effect::friction);
}

TEST_CASE("the gyroscopic term: a box that is no cube tumbles, and within bounds does not") {
  const auto spinning = [](const Point& half, const Point& angular_velocity, double duration,
                           double tolerance) {
    Scene scene = empty(1, 0, duration, tolerance);
    box(scene, half, 1, Point::Zero()).angular_velocity = angular_velocity;
    return scene;
  };
  off(spinning({1, 1, 1}, {1, 2, 3}, 100, 1e-9), Effect::gyroscopic_term);
  off(spinning({1, 2, 3}, {0, 0, 3}, 100, 1e-9), Effect::gyroscopic_term);

  const Scene nearly = spinning({1, 1, 1 + 1e-12}, {1, 2, 3}, 1e9, 1e-3);
  at_edge(nearly, Effect::gyroscopic_term, 0, 0);
  const auto& inertia = nearly.bodies[0].inertia;
  CHECK((exact(inertia(2, 2)) - exact(inertia(1, 1))) * 2 * 3 != 0);  // of ω × I ω, about x

  // A tolerance below the term's displacement of a vertex in 2 s, found by small steps.
  const Scene tumbling = spinning({1, 2, 3}, {1, 2, 3}, 2, 1e-3);
  at_edge(tumbling, Effect::gyroscopic_term, 2, 1);
  const auto& body = tumbling.bodies[0];
  const Point momentum = body.inertia * body.angular_velocity;
  contact::Quaternion<double> turned;
  for (int k = 0; k < 2000; ++k)
    turned = contact::midpoint_step<double>(turned, momentum, body.inertia.diagonal(), 1e-3);
  const auto steady = contact::exponential<double>(body.angular_velocity * 2);
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

TEST_CASE("the third dimension: one ulp of velocity, of spin or of position leaves the plane") {
  Scene flat = empty(1, 0.5, 2, 1e-6);
  box(flat, {1, 2, 3}, 1, Point::Zero(), {1, 0.25, 0}).angular_velocity = {0, 0, 2};
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
  spinning.bodies[0].angular_velocity.x() = least;
  at_edge(spinning, Effect::third_dimension, 0, 2);
  Scene asymmetric = flat;
  asymmetric.bodies[0].orientation = contact::exponential<double>({1e-9, 0, 0});
  at_edge(asymmetric, Effect::third_dimension, 0, 3);
  CHECK(contact::matrix_of(asymmetric.bodies[0].orientation)(2, 1) != 0);
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
  // It slides when it touches, so friction acts, and rotates it.
  CHECK(plan_scenes::is_on(drifting, Effect::friction));
  CHECK(plan_scenes::is_on(drifting, Effect::rotation));
}

TEST_CASE("gravity: a table cancels it only from below, and only if nothing pushes up from it") {
  // Two balls that hang at a ceiling, and fall.
  Scene hanging = empty(1, 0, 2, 1e-6);
  hanging.gravity = {0, 0, -8};
  wall(hanging, -Point::UnitZ(), 0);
  ball(hanging, 0.5, 1, {0, 0, -0.5}, {1, 0, 0});
  CHECK(plan_scenes::is_on(hanging, Effect::gravity));
  // An oblique wall deflects bodies upwards.
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

TEST_CASE("the gyroscopic term: its bound is for what touches nothing") {
  Scene scene = empty(1, 0, 2, 1e3);
  box(scene, {1, 2, 3}, 1, Point::Zero()).angular_velocity = {1, 2, 3};
  off(scene, Effect::gyroscopic_term);
  wall(scene, Point::UnitX(), -3);
  at_edge(scene, Effect::gyroscopic_term, 2, 0);
}

TEST_CASE("a crowd lies in a plane if each of its balls does, and each fixed body among them") {
  off(crowd(20), Effect::third_dimension);
  off(crowd(300), Effect::second_dimension);

  for (const int row : {20, 300}) {
    Scene lifted = crowd(row);
    lifted.bodies.back().position.z() = least;
    // Motion on a line has another plane.
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
  // On a line: beside it, in the plane.
  Scene aside = crowd(300);
  aside.bodies[150].position.y() = least;
  off(aside, Effect::third_dimension);
  at_edge(aside, Effect::second_dimension, 2, 4);

  // A fixed ball above the plane, and a box that ends below it.
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

TEST_CASE("an angular velocity whose square underflows is no reason to leave out its effect") {
  // |w|^2 is 0 in double, and the displacement is not: no error at all is accepted.
  Scene scene = empty(1, 0, 1, 0);
  box(scene, {1, 2, 3}, 1, {0, 0, 0}).angular_velocity = {0x1p-600, 0x1p-600, 0x1p-600};
  at_edge(scene, Effect::gyroscopic_term, 2, 1);
  // Without rotation there is no displacement.
  scene.bodies[0].angular_velocity = {0, 0, 0};
  off(scene, Effect::gyroscopic_term);
}
