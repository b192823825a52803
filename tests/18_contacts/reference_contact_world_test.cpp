// contact_world.hpp: boxes at rest and sliding, and invalid input.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/contact_lcp.hpp>
#include <contact/contact_solver.hpp>
#include <contact/contact_world.hpp>
#include <limits>
#include <utility>
#include <vector>

#include "reference.hpp"
#include "support/generators.hpp"
#include "support/refusal.hpp"

using contact::BodyContact;
using contact::ContactImpulse;
using contact::Matrix3;
using generators::tried;
using reference::Body;
using reference::u;
using reference::V;
using reference::vector;
using support::contains;
using support::refusal;

TEST_CASE("a stack of ten boxes does not creep") {
  std::vector<contact::ShapedBody<double>> bodies{contact::ground<double>({V(0, 0, 1), 0})};
  for (int i = 0; i < 10; ++i) {
    bodies.push_back(contact::solid_box<double>(1, V(1, 1, 1), V(0, 0, 0.5 + i)));
  }
  for (auto& body : bodies) body.friction = 0.5;
  const auto first = bodies;
  contact::StepMemory<double> memory;
  double moved = 0;
  double lowest = 0;
  bool settled = true;
  for (int step = 0; step < tried(600); ++step) {
    const auto report = contact::step_contacts(bodies, memory);
    settled = settled && report.settled;
    for (std::size_t i = 1; i < bodies.size(); ++i) {
      moved = std::max(moved, (bodies[i].motion.position - first[i].motion.position).norm());
      moved = std::max(moved, bodies[i].orientation.v.norm());
    }
    for (const auto& impulse : memory.impulses) lowest = std::min(lowest, impulse.normal);
  }
  CAPTURE(moved);
  CHECK(settled);
  // Rounding of velocities, 256 ε of the largest, for each step.
  CHECK(moved < 1e-10);
  CHECK(lowest == 0);
  // The floor supports all of them: ten kilograms for a sixtieth of a second.
  double carried = 0;
  for (std::size_t i = 0; i < memory.found.contacts.size(); ++i) {
    if (memory.found.contacts[i].a == 0) carried += memory.impulses[i].normal;
  }
  CHECK(std::abs(carried - 10 * 9.80665 / 60) < 1e-8);
}

TEST_CASE("a box that slides farther than the margin in a step starts with its own impulses") {
  std::vector<contact::ShapedBody<double>> bodies{
      contact::ground<double>({V(0, 0, 1), 0}),
      contact::solid_box<double>(1, V(1, 0.5, 0.25), V(0, 0, 0.125))};
  bodies[1].motion.velocity = V(6, 0, 0);
  for (auto& body : bodies) body.friction = 0.5;
  const contact::StepSettings<double> settings;
  contact::StepMemory<double> memory;
  contact::step_contacts(bodies, memory, settings);
  REQUIRE(memory.impulses.size() == 4);
  const auto now = contact::find_contacts(bodies, settings);
  REQUIRE((now.contacts[0].point - memory.found.contacts[0].point).norm() > 2 * settings.margin);
  const auto start = contact::detail::remembered(now, memory, settings.margin);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(now.features[i] == memory.found.features[i]);
    CHECK(start[i].normal == memory.impulses[i].normal);
    CHECK(start[i].normal > 0);
    CHECK(start[i].tangential == memory.impulses[i].tangential);
  }
}

TEST_CASE("impulses of a step belong to the pair of bodies, not to the position") {
  const V up(0, 0, 1);
  const auto at = [&](int a, int b, double x) {
    return contact::BodyContact<double>{a, b, V(x, 0, 0), up, 0, 0};
  };
  int feature = 0;  // all different, so that positions decide
  const auto found = [&](std::vector<contact::BodyContact<double>> contacts) {
    contact::FoundContacts<double> made{std::move(contacts), {}};
    for (std::size_t i = 0; i < made.contacts.size(); ++i, ++feature)
      made.features.push_back({contact::edge_feature(feature, 100), contact::edge_feature(0, 1)});
    return made;
  };
  const contact::StepMemory<double> memory{found({at(0, 1, 0), at(0, 2, 1), at(0, 2, 1.01)}),
                                           {{1, V(0, 0, 0)}, {2, V(0, 0, 0)}, {3, V(0, 0, 0)}}};
  // A pair that is new, one that is gone, and one of which a point is gone.
  const auto start =
      contact::detail::remembered(found({at(0, 2, 1.009), at(0, 3, 0), at(1, 2, 1)}), memory, 0.02);
  REQUIRE(start.size() == 3);
  CHECK(start[0].normal == 3);
  CHECK(start[1].normal == 0);
  CHECK(start[2].normal == 0);
}

// Positions and points have few digits, so that they are symmetric too.
TEST_CASE("with Jacobi's iterations an impact on two sides is symmetric to the last bit") {
  for (const double restitution : {0.0, 0.25}) {
    std::vector<contact::ShapedBody<double>> bodies{
        contact::ground<double>({V(0, 0, 1), 0}),
        contact::solid_box<double>(1, V(0.5, 0.5, 1), V(-1, 0, 0.5)),
        contact::solid_box<double>(1, V(0.5, 0.5, 1), V(1, 0, 0.5)),
        contact::solid_box<double>(2, V(3, 0.5, 0.25), V(0, 0, 1.125))};
    bodies[3].motion.velocity = V(0, 0, -1.3);
    for (auto& body : bodies) {
      body.friction = 0.5;
      body.restitution = restitution;
    }
    contact::StepSettings<double> settings;
    settings.solver.jacobi = true;
    contact::StepMemory<double> memory;
    CHECK(contact::step_contacts(bodies, memory, settings).settled);
    const auto& left = bodies[1].motion;
    const auto& right = bodies[2].motion;
    CHECK(left.position.x() == -right.position.x());
    CHECK(left.position.z() == right.position.z());
    CHECK(left.velocity.x() == -right.velocity.x());
    CHECK(left.angular_velocity.y() == -right.angular_velocity.y());
    CHECK(bodies[3].motion.velocity.x() == 0);
    CHECK(bodies[3].motion.angular_velocity == V(0, 0, 0));
  }
}

TEST_CASE("a box slides to rest after v²/(2 μ g), whatever the step") {
  for (const double step : {1.0 / 60, 1.0 / 240, 1.0 / 7}) {
    for (const V& velocity : {V(3, 0, 0), V(1.5, -2, 0), V(0.01, 0, 0)}) {
      CAPTURE(step, velocity.x());
      std::vector<contact::ShapedBody<double>> bodies{contact::ground<double>({V(0, 0, 1), 0})};
      bodies.push_back(contact::solid_box<double>(2, V(2, 2, 0.5), V(0, 0, 0.25)));
      bodies[1].motion.velocity = velocity;
      for (auto& body : bodies) body.friction = 0.4;
      contact::StepSettings<double> settings;
      settings.step = step;
      contact::StepMemory<double> memory;
      const double speed = velocity.norm();
      const int steps = static_cast<int>(speed / (0.4 * 9.80665 * step)) + 5;
      for (int k = 0; k < steps; ++k) contact::step_contacts(bodies, memory, settings);
      const V x = bodies[1].motion.position - V(0, 0, 0.25);
      CHECK((x - velocity * (speed / (2 * 0.4 * 9.80665))).norm() <= 1e-9);
    }
  }
}

TEST_CASE("a box on a slope rests or slides, depending on the angle") {
  // The tangent of the angle is 3/4: the box rests for μ = 0.8, and slides for 0.5 with g (0.6 −
  // 0.5·0.8).
  const V up(-0.6, 0, 0.8);
  const Matrix3<double> axes = (Matrix3<double>() << 0.8, 0, -0.6, 0, 1, 0, 0.6, 0, 0.8).finished();
  // The iterations of a step end at changes of 1e-11; each removes at least a ten-thousandth of the
  // error, so after sixty steps it is less than 60 · 1e-7.
  for (const double friction : {0.8, 0.5}) {
    std::vector<contact::ShapedBody<double>> bodies{contact::ground<double>({up, 0})};
    bodies.push_back(contact::solid_box<double>(2, V(2, 2, 1), V(up * 0.5)));
    // Half of the slope's angle: its cosine is 3/√10.
    bodies[1].orientation = contact::normalised(contact::Quaternion<double>{3, V(0, -1, 0)});
    bodies[1].motion = contact::rigid_body_from_axes<double>(
        2, bodies[1].moments, contact::matrix_of(bodies[1].orientation), V(up * 0.5), V(0, 0, 0),
        V(0, 0, 0));
    CHECK((contact::matrix_of(bodies[1].orientation) - axes).cwiseAbs().maxCoeff() < 8 * u);
    for (auto& body : bodies) body.friction = friction;
    contact::StepMemory<double> memory;
    for (int step = 0; step < 60; ++step) contact::step_contacts(bodies, memory);
    const double speed = friction == 0.8 ? 0.0 : 9.80665 * (0.6 - 0.5 * 0.8);
    CHECK((bodies[1].motion.velocity - V(-0.8, 0, -0.6) * speed).norm() < 6e-6);
    CHECK(bodies[1].motion.angular_velocity.norm() < 6e-6);
  }
}

TEST_CASE("friction that only makes a ball roll does not change the distance") {
  const V up(-0.6, 0, 0.8);
  std::vector<V> ends;
  for (const double friction : {1.0, 10.0}) {
    std::vector<contact::ShapedBody<double>> bodies{contact::ground<double>({up, 0})};
    bodies.push_back(contact::solid_ball<double>(2, 0.5, V(up * 0.5)));
    for (auto& body : bodies) body.friction = friction;
    contact::StepMemory<double> memory;
    for (int step = 0; step < 60; ++step) contact::step_contacts(bodies, memory);
    ends.push_back(bodies[1].motion.position);
  }
  CHECK((ends[1] - ends[0]).norm() < 1e-9);
  // 5/7 g sin/2 down the slope after a second, and half a step's way more.
  CHECK(std::abs((ends[0] - up * 0.5).norm() - 5.0 / 14 * 9.80665 * 0.6 * (1 + 1.0 / 60)) < 1e-7);
}

TEST_CASE("equal starts give equal bits, and a ball rolls, bounces and comes to rest") {
  const auto run = [] {
    std::vector<contact::ShapedBody<double>> bodies{contact::ground<double>({V(0, 0, 1), 0})};
    bodies.push_back(contact::solid_box<double>(3, V(2, 2, 2), V(0.1, 0, 2)));
    bodies.push_back(contact::solid_ball<double>(1, 0.5, V(0.5, 0.2, 4)));
    bodies.push_back(contact::solid_ball<double>(1, 0.5, V(5, 0, 1)));
    bodies[3].motion.velocity = V(1, 0, 0);
    for (auto& body : bodies) {
      body.friction = 0.6;
      body.restitution = 0.4;
    }
    contact::StepMemory<double> memory;
    for (int step = 0; step < 240; ++step) contact::step_contacts(bodies, memory);
    return bodies;
  };
  const auto one = run();
  const auto two = run();
  for (std::size_t i = 0; i < one.size(); ++i) {
    CHECK(one[i].motion.position == two[i].motion.position);
    CHECK(one[i].motion.velocity == two[i].motion.velocity);
    CHECK(one[i].orientation.v == two[i].orientation.v);
  }
  CHECK(std::abs(one[1].motion.position.z() - 1) < 1e-3);
  // Rolling without slip: v = ω × r.
  const V contact_speed =
      one[3].motion.velocity + one[3].motion.angular_velocity.cross(V(0, 0, -0.5));
  CHECK(contact_speed.norm() < 1e-6);
  CHECK(std::abs(one[3].motion.position.z() - 0.5) < 1e-3);
}

TEST_CASE("invalid contacts are refused, with the argument's name and value") {
  std::vector<Body> bodies(2);
  bodies[1] = contact::rigid_body<double>(1, Matrix3<double>::Identity(), V(0, 0, 0), V(0, 0, 0),
                                          V(0, 0, 0));
  BodyContact<double> good{1, 0, V(0, 0, 0), V(0, 0, 1), 0, 0};
  const auto refused = [&](const BodyContact<double>& c) {
    return refusal([&] { contact::solve_contacts<double>(bodies, {c}); });
  };
  CHECK(refused(good).empty());
  auto bad = good;
  bad.b = 1;
  CHECK(contains(refused(bad), "bodies 1 and 1"));
  bad.b = 2;
  CHECK(contains(refused(bad), "bodies 1 and 2"));
  bad = good;
  bad.friction = -1;
  CHECK(contains(refused(bad), "friction = -1"));
  bad = good;
  bad.normal.x() = std::numeric_limits<double>::quiet_NaN();
  CHECK(contains(refused(bad), "normal"));
  CHECK(contains(refusal([&] {
                   contact::solve_contacts<double>(bodies, {good},
                                                   std::vector<ContactImpulse<double>>(3));
                 }),
                 "3 impulses"));
}
