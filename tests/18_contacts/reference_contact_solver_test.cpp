// contact_solver.hpp: properties after any number of iterations, with friction and restitution.
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/contact_lcp.hpp>
#include <contact/contact_solver.hpp>
#include <vector>

#include "reference.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

using contact::BodyContact;
using generators::Random;
using generators::tried;
using reference::Body;
using reference::box;
using reference::down;
using reference::energy;
using reference::exactly;
using reference::momentum;
using reference::problem;
using reference::Problem;
using reference::turning;
using reference::u;
using reference::V;
using reference::vector;

TEST_CASE("without friction the iterations converge to the direct solution") {
  // At the end an iteration changes no velocity by more than 1e-13. The remaining error depends on
  // the rate of convergence: each iteration removes at least a ten-thousandth of the error in all
  // of these problems, so it is about 1e-9.
  Random random(1806);
  for (int i = 0; i < tried(150); ++i) {
    const auto p = problem(random, random.integer(2, 5), random.integer(1, 5));
    const auto d = down(p);
    const auto stored = exactly(d);
    const auto impulses = contact::complementary_impulses(stored.bodies, stored.contacts);
    REQUIRE(impulses.has_value());
    const auto right = contact::after_normal_impulses(stored.bodies, stored.contacts, *impulses);
    const bool at_once = i % 2 == 1;
    const auto got =
        contact::solve_contacts<double>(d.bodies, d.contacts, {}, {400000, 1e-13, 1.0, at_once});
    CHECK(got.report.settled);
    for (std::size_t k = 0; k < right.size(); ++k) {
      CHECK(oracle::error(got.bodies[k].velocity, right[k].velocity) <= 2e-9);
      CHECK(oracle::error(got.bodies[k].angular_velocity, right[k].angular_velocity) <= 2e-9);
    }
  }
}

TEST_CASE("after any number of iterations: no pull, friction in its cone, momentum conserved") {
  Random random(1807);
  for (int i = 0; i < tried(600); ++i) {
    auto p = down(problem(random, random.integer(3, 6), random.integer(1, 8)));
    double friction = 0;
    for (auto& c : p.contacts) {
      c.friction = random.uniform(0, 1.5);
      c.min_velocity = random.uniform(-0.5, 2);
      friction = std::max(friction, c.friction);
    }
    const std::array<int, 4> counts{1, 2, 7, 300};
    const int iterations = counts[static_cast<std::size_t>(i % 4)];
    const double relaxation = i % 3 == 0 ? 1.8 : 1.0;
    const auto got = contact::solve_contacts<double>(
        p.bodies, p.contacts, {}, {iterations, 0.0, relaxation, random.chance(0.5)});
    double pushed = 0;
    for (std::size_t k = 0; k < p.contacts.size(); ++k) {
      const auto& x = got.impulses[k];
      CHECK(x.normal >= 0);
      CHECK(x.tangential.norm() <= p.contacts[k].friction * x.normal * (1 + 32 * u));
      CHECK(std::abs(x.tangential.dot(p.contacts[k].normal)) <= 32 * u * x.tangential.norm());
      pushed += x.normal * (1 + p.contacts[k].friction);
    }
    // Each impulse is divided by both masses and added to both velocities: a few roundings each, of
    // the impulse and of the velocity. Lever arms and coordinates are below 16 m here, and the
    // product of the tensor and its stored inverse has an error of 1e2 u.
    double scale = pushed * 16;
    for (const Body& b : p.bodies) {
      scale += b.mass * b.velocity.norm() * 16 + (b.inertia * b.angular_velocity).norm();
    }
    const double room = 400 * u * double(p.contacts.size() + 1) * scale;
    bool movable = true;
    for (const auto& c : p.contacts) movable = movable && c.a != 0 && c.b != 0;
    if (movable) {
      CHECK((momentum(got.bodies) - momentum(p.bodies)).norm() <= room);
      CHECK((turning(got.bodies) - turning(p.bodies)).norm() <= room);
    }
    CHECK(got.bodies[0].velocity == V(0, 0, 0));
  }
}

TEST_CASE("contacts add no energy, with friction and restitution") {
  Random random(1808);
  int blended = 0;
  for (int i = 0; i < tried(400); ++i) {
    auto p = down(problem(random, random.integer(2, 5), random.integer(1, 6)));
    const double e = i % 2 == 0 ? 0.0 : random.uniform(0, 1);
    for (auto& c : p.contacts) {
      c.friction = random.uniform(0, 1.5);
      c.min_velocity = std::max(0.0, -e * contact::contact_velocity(p.bodies, c));
    }
    const auto got = contact::solve_contacts<double>(p.bodies, p.contacts, {},
                                                     {20000, 1e-12, 1.0, random.chance(0.5)});
    blended += got.report.blended ? 1 : 0;
    // The error of the velocities, times the momenta.
    CHECK(energy(got.bodies) <= energy(p.bodies) * (1 + 1e-9));
  }
  CHECK(blended > tried(4));
}

TEST_CASE("without restitution no number of iterations adds energy") {
  Random random(1811);
  for (int i = 0; i < tried(400); ++i) {
    auto p = down(problem(random, random.integer(2, 5), random.integer(1, 8)));
    for (auto& c : p.contacts) {
      c.friction = random.uniform(0, 1.5);
      c.min_velocity = 0;
    }
    for (const int iterations : {1, 2, 3, 10}) {
      const auto got = contact::solve_contacts<double>(p.bodies, p.contacts, {},
                                                       {iterations, 0.0, 1.0, i % 2 == 0});
      CHECK(energy(got.bodies) <= energy(p.bodies) * (1 + 1e-12));
    }
  }
}

TEST_CASE("one contact without friction is the collision of rigid bodies") {
  Random random(1809);
  for (int i = 0; i < tried(300); ++i) {
    auto p = down(problem(random, 3, 1));
    const double e = random.uniform(0, 1);
    const auto& c = p.contacts[0];
    const Body& a = p.bodies[static_cast<std::size_t>(c.a)];
    const Body& b = p.bodies[static_cast<std::size_t>(c.b)];
    const auto right = contact::collide<double>(a, b, {c.point, c.normal}, e);
    const double velocity = contact::contact_velocity(p.bodies, c);
    if (velocity >= 0) continue;
    p.contacts[0].min_velocity = -e * velocity;
    const auto got = contact::solve_contacts(p.bodies, p.contacts);
    CHECK((got.bodies[static_cast<std::size_t>(c.a)].velocity - right.a.velocity).norm() <= 1e-12);
    CHECK((got.bodies[static_cast<std::size_t>(c.b)].angular_velocity - right.b.angular_velocity)
              .norm() <= 1e-12);
  }
}

TEST_CASE(
    "a light body bounces off a very heavy one, despite the rounding of the heavy one's energy") {
  // The energy of the heavy body is 5e17 J with an ulp of 64 J; the light body gains 2,000 J.
  std::vector<Body> bodies(2);
  const double masses[] = {1e12, 1e-3};
  for (std::size_t i = 0; i < 2; ++i) {
    bodies[i].mass = masses[i];
    bodies[i].inverse_mass = 1 / masses[i];
    bodies[i].position = V(static_cast<double>(i), 0, 0);
  }
  bodies[0].velocity = V(1000, 0, 0);
  std::vector<BodyContact<double>> contacts;
  for (const double y : {-0.5, 0.5}) {
    BodyContact<double> contact;
    contact.a = 1;
    contact.b = 0;
    contact.point = V(0.5, y, 0);
    contact.normal = V(1, 0, 0);
    contact.min_velocity = 1000;
    contacts.push_back(contact);
  }
  const auto solved = contact::solve_contacts<double>(bodies, contacts);
  CHECK_FALSE(solved.report.blended);
  CHECK(std::abs(solved.bodies[1].velocity.x() - 2000) < 1e-9);
}
