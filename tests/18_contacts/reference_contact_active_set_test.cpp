// contact_active_set.hpp: the active-set solve reaches the direct solution, within the error of the
// report.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/contact_active_set.hpp>
#include <contact/contact_lcp.hpp>
#include <contact/contact_solver.hpp>
#include <vector>

#include "reference.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

using contact::BodyContact;
using contact::ContactImpulse;
using generators::Random;
using generators::tried;
using reference::Body;
using reference::down;
using reference::energy;
using reference::exactly;
using reference::problem;
using reference::u;
using reference::V;
using reference::vector;

namespace {

/// Makes a body heavier.
void make_heavier(Body& body, double factor) {
  body.mass *= factor;
  body.inertia *= factor;
  body.inverse_mass /= factor;
  body.inverse_inertia /= factor;
}

}  // namespace

TEST_CASE("the active-set solve reaches the direct solution, with mass ratios of a million") {
  // Every other body is 2^20 times as heavy. The iterations would take millions to bring a light
  // body between two heavy ones to rest; elimination starts from none of them, or from a few. The
  // velocities of the heavy bodies come with impulses a million times those of the light ones:
  // their rounding is a few times 2^20 u of these.
  Random random(1816);
  for (int i = 0; i < tried(150); ++i) {
    auto d = down(problem(random, random.integer(3, 6), random.integer(1, 6)));
    for (std::size_t k = 1; k < d.bodies.size(); k += 2) make_heavier(d.bodies[k], 0x1p20);
    const auto stored = exactly(d);
    const auto impulses = contact::complementary_impulses(stored.bodies, stored.contacts);
    REQUIRE(impulses.has_value());
    const auto right = contact::after_normal_impulses(stored.bodies, stored.contacts, *impulses);
    const std::vector<ContactImpulse<double>> none(d.contacts.size());
    const auto swept =
        contact::solve_contacts<double>(d.bodies, d.contacts, {}, {random.integer(1, 20), 0.0});
    for (const auto& start : {none, swept.impulses}) {
      const auto got = contact::solve_active_set<double>(d.bodies, d.contacts, start);
      REQUIRE(got.has_value());
      for (std::size_t k = 0; k < right.size(); ++k) {
        CHECK(oracle::error(got->bodies[k].velocity, right[k].velocity) <= 1e-7);
        CHECK(oracle::error(got->bodies[k].angular_velocity, right[k].angular_velocity) <= 1e-7);
      }
    }
  }
}

TEST_CASE(
    "a light ball between two a million times as heavy: a million iterations are not enough") {
  std::vector<Body> bodies;
  for (int k = 0; k < 3; ++k) {
    const double mass = k == 1 ? 1 : 1e6;
    bodies.push_back(contact::rigid_body<double>(mass, contact::sphere_inertia<double>(mass, 0.5),
                                                 {double(k), 0, 0}, {1.0 - k, 0, 0}, {0, 0, 0}));
  }
  std::vector<BodyContact<double>> contacts(2);
  for (int k = 0; k < 2; ++k) {
    auto& c = contacts[static_cast<std::size_t>(k)];
    c.a = k + 1;
    c.b = k;
    c.point = {k + 0.5, 0, 0};
    c.normal = {1, 0, 0};
  }
  const auto swept = contact::solve_contacts<double>(bodies, contacts, {}, {1000000, 1e-3});
  CHECK(swept.report.last_change > 0.1);
  const auto got = contact::solve_active_set<double>(bodies, contacts, swept.impulses);
  REQUIRE(got.has_value());
  for (const auto& c : contacts) CHECK(contact::contact_velocity(got->bodies, c) > -1e-9);
}

TEST_CASE("a row of light balls between heavy ones: iterations do not converge, elimination does") {
  // One half of the row moves towards the other. All contacts are touching, and those that close
  // separate with the same speed: no energy is lost.
  std::vector<Body> bodies;
  std::vector<BodyContact<double>> contacts;
  for (int k = 0; k < 12; ++k) {
    const double mass = k % 3 == 0 ? 1e6 : 1;
    bodies.push_back(contact::rigid_body<double>(mass, contact::sphere_inertia<double>(mass, 0.5),
                                                 {double(k), 0, 0}, {k < 6 ? 1.0 : -1.0, 0, 0},
                                                 {0, 0, 0}));
  }
  for (int k = 0; k + 1 < 12; ++k) {
    BodyContact<double> c;
    c.a = k + 1;
    c.b = k;
    c.point = {k + 0.5, 0, 0};
    c.normal = {1, 0, 0};
    c.min_velocity = -contact::contact_velocity(bodies, c);
    contacts.push_back(c);
  }
  const auto swept = contact::solve_contacts<double>(bodies, contacts, {}, {100, 1e-7});
  CHECK(swept.report.last_change > 1e-3);
  const auto got = contact::solve_active_set<double>(bodies, contacts, swept.impulses);
  REQUIRE(got.has_value());
  CHECK(std::abs(energy(got->bodies) / energy(bodies) - 1) < 1e-8);  // of masses 1 : 10⁶
  for (const auto& c : contacts)
    CHECK(contact::contact_velocity(got->bodies, c) >= c.min_velocity - 1e-7);
}

TEST_CASE("bodies under a heavy load come to rest, within the error of the report") {
  for (const double weight : {1e3, 1e6, 1e9}) {
    CAPTURE(weight);
    std::vector<Body> bodies{contact::immovable<double>({0, 0, 0}, {0, 0, 0}, {0, 0, 0})};
    std::vector<BodyContact<double>> contacts;
    for (int k = 1; k <= 10; ++k) {
      const double mass = k == 10 ? weight : 1;
      bodies.push_back(
          contact::rigid_body<double>(mass, contact::box_inertia<double>(mass, {1, 1, 1}),
                                      {0.1 * (k % 2), 0, k - 0.5}, {0, 0, -0.1}, {0, 0, 0}));
      for (const double x : {-0.3, 0.35}) {
        for (const double y : {-0.5, 0.5}) {
          BodyContact<double> c;
          c.a = k;
          c.b = k - 1;
          c.point = {x, y, k - 1.0};
          c.normal = {0, 0, 1};
          c.friction = 0.5;
          contacts.push_back(c);
        }
      }
    }
    const auto swept = contact::solve_contacts<double>(bodies, contacts, {}, {100, 1e-12});
    CHECK(swept.report.last_change > 1e-4);
    const auto got = contact::solve_active_set<double>(bodies, contacts, swept.impulses);
    REQUIRE(got.has_value());
    CHECK(got->report.rounding < weight * 1e-11);
    for (const auto& c : contacts)
      CHECK(std::abs(contact::contact_velocity(got->bodies, c)) <=
            std::max(1e-10, got->report.rounding));
  }
}

TEST_CASE("a result that rounding decides has not settled") {
  // A ball of 2^e kg on one of 1 kg on the ground, which approach at 1 m/s.
  for (const int e : {40, 44, 48}) {
    CAPTURE(e);
    const V zero(0, 0, 0);
    const V up(0, 0, 1);
    const V falls(0, 0, -1);
    const auto ball = [&](double mass, const V& position) {
      return contact::rigid_body<double>(mass, contact::sphere_inertia<double>(mass, 0.5), position,
                                         falls, zero);
    };
    const std::vector<contact::RigidBody<double>> bodies{
        contact::immovable<double>(zero, zero, zero), ball(1, V(0, 0, 0.5)),
        ball(std::ldexp(1.0, e), V(0, 0, 1.5))};
    const std::vector<contact::BodyContact<double>> contacts{{1, 0, zero, up, 0, 0},
                                                             {2, 1, up, up, 0, 0}};
    const auto got = contact::solve_active_set<double>(
        bodies, contacts, std::vector<contact::ContactImpulse<double>>(2));
    if (got) CHECK((!got->report.settled || got->report.residual < 1e-6));
  }
}

TEST_CASE("masses that a sum of inverses cannot hold do not settle") {
  const V zero(0, 0, 0);
  const V up(0, 0, 1);
  const auto body = [&](double mass, const V& position) {
    contact::RigidBody<double> made;  // rigid_body() refuses so small moments of inertia
    made.mass = mass;
    made.inverse_mass = 1 / mass;
    made.inertia = contact::Matrix3<double>::Identity() * mass;
    made.inverse_inertia = contact::Matrix3<double>::Identity() / mass;
    made.position = position;
    made.velocity = -up;
    return made;
  };
  const std::vector<contact::RigidBody<double>> bodies{contact::immovable<double>(zero, zero, zero),
                                                       body(0x1p-500, V(0, 0, 0.5)),
                                                       body(100 * 0x1p500, V(0, 0, 1.5))};
  const std::vector<contact::BodyContact<double>> contacts{{1, 0, zero, up, 0, 0},
                                                           {2, 1, up, up, 0, 0}};
  for (const int iterations : {10, 1000})
    CHECK_FALSE(
        contact::solve_contacts<double>(bodies, contacts, {}, {iterations, 1e-15}).report.settled);
  const auto exact = contact::solve_active_set<double>(
      bodies, contacts, std::vector<contact::ContactImpulse<double>>(2));
  CHECK((!exact || !exact->report.settled));
}

TEST_CASE("the active-set solve closes no faster, adds no energy, and keeps friction in its cone") {
  Random random(1817);
  int finished = 0;
  for (int i = 0; i < tried(400); ++i) {
    auto p = down(problem(random, random.integer(3, 8), random.integer(2, 14)));
    for (std::size_t k = 1; k < p.bodies.size(); k += 2) make_heavier(p.bodies[k], 0x1p12);
    const double e = i % 2 == 0 ? 0.0 : random.uniform(0, 1);
    for (auto& c : p.contacts) {
      c.friction = random.uniform(0, 1.5);
      c.min_velocity = std::max(0.0, -e * contact::contact_velocity(p.bodies, c));
    }
    const auto swept = contact::solve_contacts<double>(p.bodies, p.contacts, {}, {10, 0.0});
    const auto got = contact::solve_active_set<double>(p.bodies, p.contacts, swept.impulses);
    if (!got) continue;
    ++finished;
    CHECK(energy(got->bodies) <= energy(p.bodies) * (1 + 1e-9));
    double before = 0;
    double after = 0;
    double fastest = 0;
    for (std::size_t k = 0; k < p.contacts.size(); ++k) {
      const auto& c = p.contacts[k];
      const auto& x = got->impulses[k];
      fastest = std::max(fastest, std::abs(contact::contact_velocity(p.bodies, c)));
      CHECK(x.normal >= 0);
      CHECK(x.tangential.norm() <= c.friction * x.normal * (1 + 32 * u));
      before = std::max(before, c.min_velocity - contact::contact_velocity(swept.bodies, c));
      after = std::max(after, c.min_velocity - contact::contact_velocity(got->bodies, c));
    }
    const double rounding = std::min(got->report.rounding, contact::max_rounding * fastest);
    if (!got->report.blended) CHECK(after <= before + std::max(0x1p-25 * fastest, rounding));
  }
  CHECK(finished > tried(400) / 2);
}

TEST_CASE(
    "the active-set solve obeys Coulomb's law: friction opposes the slip, or contacts stick") {
  // Velocities are right to 2^14 roundings of the sum of their absolute terms, 64 times the bound
  // of the report; impulses to 2^14 u of the largest.
  Random random(1818);
  int finished = 0;
  int slides = 0;
  for (int i = 0; i < tried(150); ++i) {
    auto p = down(problem(random, random.integer(3, 8), random.integer(2, 12)));
    for (std::size_t k = 1; k < p.bodies.size(); k += 2)
      make_heavier(p.bodies[k], i % 2 == 0 ? 0x1p10 : 0x1p20);
    for (auto& c : p.contacts) c.friction = random.uniform(0, 1);
    const auto swept = contact::solve_contacts<double>(p.bodies, p.contacts, {}, {100, 0.0});
    const auto got = contact::solve_active_set<double>(p.bodies, p.contacts, swept.impulses);
    if (!got) continue;
    ++finished;
    CHECK(energy(got->bodies) <= energy(p.bodies) * (1 + 1e-9));
    const double wrong = 256 * got->report.rounding;
    double largest = 0;
    for (const auto& x : got->impulses) largest = std::max(largest, x.normal);
    for (std::size_t k = 0; k < p.contacts.size(); ++k) {
      const auto& c = p.contacts[k];
      const auto& x = got->impulses[k];
      const V between = contact::velocity_at(got->bodies[static_cast<std::size_t>(c.a)], c.point) -
                        contact::velocity_at(got->bodies[static_cast<std::size_t>(c.b)], c.point);
      const V slip = between - c.normal * c.normal.dot(between);
      CAPTURE(i, k, x.normal, slip.norm(), wrong);
      CHECK(c.normal.dot(between) >= -wrong);
      if (x.normal > 0x1p-36 * largest) CHECK(c.normal.dot(between) <= wrong);
      CHECK(x.tangential.norm() <= c.friction * x.normal * (1 + 32 * u));
      // It dissipates as much energy as any friction in its cone can.
      const double most = c.friction * x.normal;
      CHECK(x.tangential.dot(slip) + most * slip.norm() <=
            2 * most * wrong + 0x1p-36 * largest * slip.norm());
      if (slip.norm() > wrong && x.normal > 0x1p-36 * largest) ++slides;
    }
  }
  CAPTURE(finished, slides);
  CHECK(finished > tried(150) * 4 / 5);
  CHECK(slides > tried(150));
}

TEST_CASE("friction by the cones alone adds no energy, and no contact closes") {
  Random random(1819);
  int finished = 0;
  for (int i = 0; i < tried(100); ++i) {
    auto p = down(problem(random, random.integer(3, 6), random.integer(2, 6)));
    for (std::size_t k = 1; k < p.bodies.size(); k += 2) make_heavier(p.bodies[k], 0x1p10);
    for (auto& c : p.contacts) c.friction = random.uniform(0, 1);
    const std::vector<ContactImpulse<double>> none(p.contacts.size());
    const auto got =
        contact::solve_active_set<double>(p.bodies, p.contacts, none, contact::FrictionLaw::cones);
    if (!got) continue;
    ++finished;
    CHECK(energy(got->bodies) <= energy(p.bodies) * (1 + 1e-9));
    double fastest = 0;
    for (const auto& c : p.contacts)
      fastest = std::max(fastest, std::abs(contact::contact_velocity(p.bodies, c)));
    for (std::size_t k = 0; k < p.contacts.size(); ++k) {
      const auto& x = got->impulses[k];
      CHECK(x.tangential.norm() <= p.contacts[k].friction * x.normal * (1 + 32 * u));
      CHECK(contact::contact_velocity(got->bodies, p.contacts[k]) >= -1e-6 * fastest);
    }
  }
  CHECK(finished > tried(100) * 4 / 5);
}

TEST_CASE("plates on a slope come to rest, or to one speed, under any load") {
  for (const double load : {1.0, 1e3, 1e6}) {
    for (const double steep : {0.5, 0.99, 1.01, 2.0}) {  // times the tangent of the friction angle
      CAPTURE(load, steep);
      // The slope is the plane of x and y here: g h is 1/6, at the angle whose tangent is steep/2.
      const double cosine = 1 / std::sqrt(1 + steep * steep / 4);
      const V free = V(steep / 2, 0, -1) * (cosine / 6);
      std::vector<Body> bodies{contact::immovable<double>({0, 0, 0}, {0, 0, 0}, {0, 0, 0})};
      std::vector<BodyContact<double>> contacts;
      for (int k = 1; k <= 4; ++k) {
        const double mass = k == 4 ? load : 1;
        bodies.push_back(
            contact::rigid_body<double>(mass, contact::box_inertia<double>(mass, {1, 1, 0.1}),
                                        {0, 0, 0.1 * k - 0.05}, free, {0, 0, 0}));
        for (const double x : {-0.5, 0.5}) {
          for (const double y : {-0.5, 0.5}) {
            BodyContact<double> c;
            c.a = k;
            c.b = k - 1;
            c.point = {x, y, 0.1 * (k - 1)};
            c.normal = {0, 0, 1};
            c.friction = 0.5;
            contacts.push_back(c);
          }
        }
      }
      const auto swept = contact::solve_contacts<double>(bodies, contacts, {}, {100, 1e-12});
      const auto got = contact::solve_active_set<double>(bodies, contacts, swept.impulses);
      REQUIRE(got.has_value());
      const double speed = std::max(0.0, free.x() + free.z() / 2);
      const double wrong = 64 * std::max(1e-12, got->report.rounding);
      CHECK((got->bodies[4].velocity - V(speed, 0, 0)).norm() <= wrong);
      CHECK(energy(got->bodies) <= energy(bodies));
      // A sliding plate is at the limit on both faces: any velocity between slope and load is a
      // solution.
      for (std::size_t k = 1; k < 4; ++k) {
        const V v = got->bodies[k].velocity;
        CHECK(v.x() >= -wrong);
        CHECK(v.x() <= speed + wrong);
        CHECK((v - V(v.x(), 0, 0)).norm() <= wrong);
      }
    }
  }
}

TEST_CASE("unsolvable contacts return nothing") {
  const std::vector<Body> walls(2, contact::immovable<double>({0, 0, 0}, {0, 0, 0}, {0, 0, 0}));
  BodyContact<double> c;
  c.a = 0;
  c.b = 1;
  c.normal = {1, 0, 0};
  CHECK_FALSE(contact::solve_active_set<double>(walls, {c}, {{}}).has_value());
  std::vector<Body> pair = walls;
  pair[0] = contact::rigid_body<double>(1, contact::sphere_inertia<double>(1, 1), {0, 0, 0},
                                        {0, 0, 0}, {0, 0, 0});
  const auto couplings = static_cast<double>(contact::max_couplings);
  const auto many = static_cast<std::size_t>(std::sqrt(couplings)) + 1;
  const std::vector<ContactImpulse<double>> none(many);
  CHECK_FALSE(contact::solve_active_set<double>(pair, std::vector(many, c), none).has_value());
  CHECK(contact::solve_active_set<double>(pair, {c}, {{}}).has_value());
}

TEST_CASE("more impulses than velocities: the active-set solve takes those nearest to its start") {
  // A plate on 12 supports without friction, with a load that is not in the middle: three supports
  // would be enough. Of all impulses that stop it, the nearest to the start, measured with the
  // effective masses, differ from it by the velocities that a rigid motion gives to the points,
  // divided by the inverse effective masses: these are linear in the position.
  Random random(1826);
  for (int i = 0; i < tried(50); ++i) {
    const double mass = 2;
    std::vector<Body> bodies;
    bodies.push_back(contact::immovable<double>({0, 0, 0}, {0, 0, 0}, {0, 0, 0}));
    bodies.push_back(
        contact::rigid_body<double>(mass, contact::box_inertia<double>(mass, {4, 3, 0.5}),
                                    {1.5, 1, 0.25}, {0, 0, random.uniform(-1.6, -1.4)},
                                    {random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), 0}));
    std::vector<BodyContact<double>> contacts;
    std::vector<ContactImpulse<double>> start;
    for (int x = 0; x < 4; ++x) {
      for (int y = 0; y < 3; ++y) {
        contacts.push_back({1, 0, {double(x), double(y), 0}, {0, 0, 1}, 0.0, 0.0});
        start.push_back({random.uniform(0.2, 0.3), V::Zero()});
      }
    }
    const auto got = contact::active_set_impulses<double>(bodies, contacts, start);
    REQUIRE(got.has_value());
    std::vector<double> change;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      const auto& c = contacts[k];
      REQUIRE((*got)[k].normal > 0);
      change.push_back(((*got)[k].normal - start[k].normal) *
                       contact::inverse_effective_mass<double>(bodies[1], bodies[0], c.point,
                                                               c.normal, c.normal));
    }
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      const V& p = contacts[k].point;
      const double linear =
          change[0] + p.x() * (change[3] - change[0]) + p.y() * (change[1] - change[0]);
      CHECK(std::abs(change[k] - linear) < 1e-9);
    }
    const auto solved = contact::solve_active_set<double>(bodies, contacts, start);
    REQUIRE(solved.has_value());
    for (const auto& c : contacts)
      CHECK(std::abs(contact::contact_velocity(solved->bodies, c)) < 1e-12);
  }
}
