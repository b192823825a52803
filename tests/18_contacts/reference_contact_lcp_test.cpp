// contact_lcp.hpp in fractions: the direct solution of simultaneous contacts.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <contact/contact_lcp.hpp>
#include <vector>

#include "reference.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/refusal.hpp"

using contact::BodyContact;
using generators::Random;
using generators::tried;
using oracle::Rational;
using oracle::Vector;
using reference::energy;
using reference::Exactly;
using reference::momentum;
using reference::problem;
using reference::turning;
using reference::vector;
using support::contains;
using support::refusal;

TEST_CASE("the direct solution, in fractions: complementarity, momentum, minimum energy") {
  Random random(1804);
  int pushes = 0;
  for (int i = 0; i < tried(120); ++i) {
    auto p = problem(random, random.integer(3, 5), random.integer(1, 6));
    const auto impulses = contact::complementary_impulses(p.bodies, p.contacts);
    REQUIRE(impulses.has_value());
    const auto after = contact::after_normal_impulses(p.bodies, p.contacts, *impulses);
    for (std::size_t k = 0; k < p.contacts.size(); ++k) {
      const Rational velocity = contact::contact_velocity(after, p.contacts[k]);
      CHECK((*impulses)[k] >= 0);
      CHECK(velocity >= 0);
      CHECK((*impulses)[k] * velocity == 0);
      pushes += (*impulses)[k] > 0 ? 1 : 0;
    }
    CHECK(energy(after) <= energy(p.bodies));
    // No other admissible impulses leave less energy.
    for (int other = 0; other < 5; ++other) {
      std::vector<Rational> changed = *impulses;
      for (Rational& x : changed) {
        x += Rational(random.integer(-3, 3)) / 16;
        if (x < 0) x = 0;
      }
      CHECK(energy(after) <= energy(contact::after_normal_impulses(p.bodies, p.contacts, changed)));
    }
    // Between movable bodies momentum and angular momentum are conserved.
    bool movable = true;
    for (const auto& c : p.contacts) movable = movable && c.a != 0 && c.b != 0;
    if (movable) {
      CHECK(momentum(after) == momentum(p.bodies));
      CHECK(turning(after) == turning(p.bodies));
    }
    // The velocities do not depend on the order of the contacts.
    auto turned = p;
    std::rotate(turned.contacts.begin(), turned.contacts.begin() + 1, turned.contacts.end());
    const auto again = contact::complementary_impulses(turned.bodies, turned.contacts);
    REQUIRE(again.has_value());
    const auto also = contact::after_normal_impulses(turned.bodies, turned.contacts, *again);
    for (std::size_t k = 0; k < after.size(); ++k) {
      CHECK(also[k].velocity == after[k].velocity);
      CHECK(also[k].angular_velocity == after[k].angular_velocity);
    }
  }
  CHECK(pushes > tried(100));
}

TEST_CASE("simultaneous restitution conserves or loses energy, in fractions") {
  Random random(1805);
  for (int i = 0; i < tried(100); ++i) {
    auto p = problem(random, 4, random.integer(1, 5));
    const Rational e = Rational(random.integer(0, 4)) / 4;
    for (auto& c : p.contacts) c.min_velocity = -e * contact::contact_velocity(p.bodies, c);
    const auto impulses = contact::complementary_impulses(p.bodies, p.contacts);
    REQUIRE(impulses.has_value());
    const auto after = contact::after_normal_impulses(p.bodies, p.contacts, *impulses);
    CHECK(energy(after) <= energy(p.bodies));
    if (e == 1) CHECK(energy(after) == energy(p.bodies));
  }
}

TEST_CASE("a table on four legs, and problems without a solution") {
  std::vector<Exactly> bodies;
  bodies.push_back(contact::immovable<Rational>({0, 0, 0}, {0, 0, 0}, {0, 0, 0}));
  bodies.push_back(contact::rigid_body<Rational>(4, contact::box_inertia<Rational>(4, {2, 2, 1}),
                                                 {0, 0, 1}, {0, 0, -1}, {0, 0, 0}));
  std::vector<BodyContact<Rational>> legs;
  for (const int x : {-1, 1}) {
    for (const int y : {-1, 1}) legs.push_back({1, 0, {x, y, 0}, {0, 0, 1}, 0, 0});
  }
  const auto impulses = contact::complementary_impulses(bodies, legs);
  REQUIRE(impulses.has_value());
  Rational sum = 0;
  for (const Rational& x : *impulses) sum += x;
  CHECK(sum == 4);
  const auto after = contact::after_normal_impulses(bodies, legs, *impulses);
  CHECK(after[1].velocity == Vector(0, 0, 0));
  CHECK(after[1].angular_velocity == Vector(0, 0, 0));
  bodies[1] = contact::immovable<Rational>({0, 0, 1}, {0, 0, -1}, {0, 0, 0});
  CHECK_FALSE(contact::complementary_impulses(bodies, legs).has_value());
  const std::vector<BodyContact<Rational>> many(13, legs[0]);
  CHECK(contains(refusal([&] { contact::complementary_impulses(bodies, many); }), "13 rows"));
}
