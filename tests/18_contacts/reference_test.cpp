// Contacts: their points against fractions and closed forms, several at once against the exact
// solution of the complementarity problem, and what must hold after any number of sweeps.
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/contact_finish.hpp>
#include <contact/contact_lcp.hpp>
#include <contact/contact_manifold.hpp>
#include <contact/contact_solver.hpp>
#include <contact/contact_world.hpp>
#include <contact/exact_distance.hpp>
#include <limits>
#include <string>
#include <vector>

#include "09_separating_planes/random_poses.hpp"
#include "09_separating_planes/shape_oracle.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/refusal.hpp"

using contact::BodyContact;
using contact::Capsule;
using contact::ContactImpulse;
using contact::HalfSpace;
using contact::Matrix3;
using contact::OrientedBox;
using contact::RigidBody;
using contact::Sphere;
using contact::Vector3;
using generators::Random;
using generators::tried;
using oracle::Rational;
using oracle::Vector;
using random_poses::any_point;
using random_poses::direction;
using random_poses::turn;
using support::contains;
using support::refusal;

namespace {

using V = Vector3<double>;
using Box = OrientedBox<double>;
using Body = RigidBody<double>;
using Exactly = RigidBody<Rational>;
constexpr double u = 0x1p-53;

Box box(Random& random) {
  const V place = any_point(random, 1.5);
  const Matrix3<double> axes = turn(random);
  const double x = random.uniform(0.2, 2);
  const double y = random.uniform(0.2, 2);
  return {place, axes, V(x, y, random.uniform(0.2, 2))};
}
double size_of(const Box& b) { return b.centre.cwiseAbs().sum() + b.half_lengths.sum(); }

/// Whether a point is in the box, or at most `room` away: exactly.
bool near_box(const V& p, const Box& b, double room) {
  return contact::exact_squared_distance<Rational>(oracle::exact(p), shape_oracle::exact(b)) <=
         oracle::exact(room) * oracle::exact(room);
}

Rational fraction(Random& random) { return Rational(random.integer(-9, 9)) / random.integer(1, 4); }
Vector vector(Random& random) {
  const Rational x = fraction(random);
  const Rational y = fraction(random);
  return {x, y, fraction(random)};
}

/// Some bodies, the first immovable and at rest, and contacts between any two of them.
template <class S>
struct Problem {
  std::vector<RigidBody<S>> bodies;
  std::vector<BodyContact<S>> contacts;
};
Problem<Rational> problem(Random& random, int count, int contacts) {
  Problem<Rational> p;
  p.bodies.push_back(contact::immovable<Rational>(vector(random), {0, 0, 0}, {0, 0, 0}));
  for (int i = 1; i < count; ++i) {
    const Rational mass = Rational(random.integer(1, 8)) / 2;
    const Vector size{Rational(random.integer(1, 4)), Rational(random.integer(1, 4)),
                      Rational(random.integer(1, 4))};
    const Vector x = vector(random);
    const Vector v = vector(random);
    p.bodies.push_back(contact::rigid_body<Rational>(
        mass, contact::box_inertia<Rational>(mass, size), x, v, vector(random)));
  }
  for (int i = 0; i < contacts; ++i) {
    BodyContact<Rational> c;
    c.a = random.integer(1, count - 1);
    c.b = (c.a + random.integer(1, count - 1)) % count;
    c.point = vector(random);
    c.normal = shape_oracle::rotation(random, false).col(0);
    p.contacts.push_back(c);
  }
  return p;
}
double down(const Rational& x) { return oracle::nearest(x); }
V down(const Vector& v) { return oracle::nearest(v); }
Matrix3<double> down(const Matrix3<Rational>& m) { return shape_oracle::rounded(m); }
Problem<double> down(const Problem<Rational>& p) {
  Problem<double> d;
  for (const Exactly& b : p.bodies) {
    d.bodies.push_back({down(b.mass), down(b.inertia), down(b.inverse_mass),
                        down(b.inverse_inertia), down(b.position), down(b.velocity), down(b.spin)});
  }
  for (const auto& c : p.contacts) {
    d.contacts.push_back(
        {c.a, c.b, down(c.point), down(c.normal), down(c.friction), down(c.least_velocity)});
  }
  return d;
}

/// The numbers that are stored, as fractions.
Problem<Rational> exactly(const Problem<double>& d) {
  Problem<Rational> stored;
  for (const Body& b : d.bodies) {
    stored.bodies.push_back({oracle::exact(b.mass), shape_oracle::exact(b.inertia),
                             oracle::exact(b.inverse_mass), shape_oracle::exact(b.inverse_inertia),
                             oracle::exact(b.position), oracle::exact(b.velocity),
                             oracle::exact(b.spin)});
  }
  for (const auto& c : d.contacts) {
    stored.contacts.push_back({c.a, c.b, oracle::exact(c.point), oracle::exact(c.normal),
                               oracle::exact(c.friction), oracle::exact(c.least_velocity)});
  }
  return stored;
}

/// Makes a body heavier.
void make_heavier(Body& body, double factor) {
  body.mass *= factor;
  body.inertia *= factor;
  body.inverse_mass /= factor;
  body.inverse_inertia /= factor;
}

template <class S>
S energy(const std::vector<RigidBody<S>>& bodies) {
  S sum(0);
  for (const auto& b : bodies) sum = sum + contact::kinetic_energy(b);
  return sum;
}
template <class S>
Vector3<S> momentum(const std::vector<RigidBody<S>>& bodies) {
  Vector3<S> sum = Vector3<S>::Zero();
  for (const auto& b : bodies) sum = sum + Vector3<S>(b.velocity * b.mass);
  return sum;
}
template <class S>
Vector3<S> turning(const std::vector<RigidBody<S>>& bodies) {
  Vector3<S> sum = Vector3<S>::Zero();
  for (const auto& b : bodies) sum = sum + contact::angular_momentum<S>(b, Vector3<S>::Zero());
  return sum;
}

const HalfSpace<double> floor_at_zero{{V(0, 0, 1), 0}};

}  // namespace

TEST_CASE("a box on a floor: the corners within the margin, at most the four lowest") {
  const Box flat{V(1, 2, 1), Matrix3<double>::Identity(), V(3, 2, 1)};
  const auto rest = contact::contact_manifold(flat, floor_at_zero, 0.0);
  REQUIRE(rest.points.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(rest.points[i].point == contact::box_corner(flat, static_cast<int>(i)));
    CHECK(rest.points[i].distance == 0);
  }
  Random random(1801);
  for (int i = 0; i < tried(500); ++i) {
    const Box b = box(random);
    const HalfSpace<double> h{{direction(random), random.uniform(-1, 1)}};
    const double margin = random.uniform(0, 0.5);
    const double room = 32 * u * (size_of(b) + 1);
    const auto manifold = contact::contact_manifold(b, h, margin);
    const Vector n = oracle::exact(h.boundary.normal);
    std::vector<Rational> height;
    for (int k = 0; k < 8; ++k) {
      height.push_back(n.dot(contact::box_corner<Rational>(shape_oracle::exact(b), k)) -
                       oracle::exact(h.boundary.offset));
    }
    std::sort(height.begin(), height.end());
    std::size_t right = 0;
    while (right < 4 && height[right] <= oracle::exact(margin)) ++right;
    REQUIRE(manifold.points.size() == right);
    std::vector<double> got;
    for (const auto& p : manifold.points) {
      got.push_back(p.distance);
      // Midway: as far from the box's corner as from the floor.
      CHECK(near_box(V(p.point + manifold.normal * (p.distance / 2)), b, room));
      CHECK(std::abs(contact::signed_distance(h.boundary, p.point) - p.distance / 2) <= room);
    }
    std::sort(got.begin(), got.end());
    for (std::size_t k = 0; k < got.size(); ++k) CHECK(oracle::error(got[k], height[k]) <= room);
  }
}

TEST_CASE("a box on a box: the corners of the overlap of two rectangles, in closed form") {
  Random random(1802);
  for (int i = 0; i < tried(2000); ++i) {
    const V half(random.integer(1, 4), random.integer(1, 4), 2);
    const V other(random.integer(1, 4), random.integer(1, 4), 2);
    const double x = random.integer(-3, 3);
    const double y = random.integer(-3, 3);
    const double depth = random.integer(0, 1) / 16.0;
    const Box a{V(x, y, 4 - depth), Matrix3<double>::Identity(), half};
    const Box b{V(0, 0, 0), Matrix3<double>::Identity(), other};
    const double left = std::max(x - half.x(), -other.x());
    const double right = std::min(x + half.x(), other.x());
    const double front = std::max(y - half.y(), -other.y());
    const double back = std::min(y + half.y(), other.y());
    if (right - left <= 1 || back - front <= 1) continue;  // then a side may be the way out
    const auto manifold = contact::contact_manifold(a, b, 0.0);
    CHECK(manifold.normal == V(0, 0, 1));
    REQUIRE(manifold.points.size() == 4);
    std::vector<std::array<double, 2>> got;
    for (const auto& p : manifold.points) {
      CHECK(p.distance == -depth);
      CHECK(p.point.z() == 2 - depth / 2);
      got.push_back({p.point.x(), p.point.y()});
    }
    std::sort(got.begin(), got.end());
    const std::vector<std::array<double, 2>> wanted{
        {left, front}, {left, back}, {right, front}, {right, back}};
    CHECK(got == wanted);
  }
}

TEST_CASE("the points of two boxes lie midway between both surfaces, whatever the pose") {
  Random random(1803);
  int faces = 0;
  int edges = 0;
  for (int i = 0; i < tried(600); ++i) {
    const Box a = box(random);
    const Box b = box(random);
    const double room = 128 * u * (size_of(a) + size_of(b));
    const auto manifold = contact::contact_manifold(a, b, 0.0);
    const auto gap = contact::gap(a, b);
    if (gap.distance > room) CHECK(manifold.points.empty());
    if (gap.distance < -room) CHECK_FALSE(manifold.points.empty());
    CHECK(manifold.points.size() <= 8);
    faces += manifold.points.size() > 1 ? 1 : 0;
    edges += manifold.points.size() == 1 ? 1 : 0;
    for (const auto& p : manifold.points) {
      CHECK(p.distance <= room);
      const V half = manifold.normal * (p.distance / 2);
      CHECK(near_box(V(p.point + half), a, room));
      CHECK(near_box(V(p.point - half), b, room));
    }
    const auto back = contact::contact_manifold(b, a, 0.0);
    CHECK(back.points.empty() == manifold.points.empty());
  }
  CHECK(faces > tried(60));
  CHECK(edges > tried(8));
}

TEST_CASE("where corners meet the normal is always the same") {
  const Box a{V(2, 2, 2), Matrix3<double>::Identity(), V(1, 1, 1)};
  const Box b{V(0, 0, 0), Matrix3<double>::Identity(), V(1, 1, 1)};
  const auto corner = contact::contact_manifold(a, b, 0.0);
  REQUIRE(corner.points.size() == 1);
  CHECK(corner.normal == V(1, 0, 0));
  CHECK(corner.points[0].point == V(1, 1, 1));
  CHECK(corner.points[0].distance == 0);
  const auto back = contact::contact_manifold(b, a, 0.0);
  CHECK(back.normal == V(-1, 0, 0));
  CHECK(back.points.size() == 1);
  // A gap on the diagonal: no face shows how far it is, and the margin counts the true distance.
  const Box off{V(2.01, 2.01, 2.01), Matrix3<double>::Identity(), V(1, 1, 1)};
  CHECK(contact::contact_manifold(off, b, 0.015).points.empty());
  const auto near = contact::contact_manifold(off, b, 0.02);
  REQUIRE(near.points.size() == 1);
  CHECK(std::abs(near.points[0].distance - 0.01 * std::sqrt(3.0)) <= 1e-15);
  CHECK((near.normal - V(1, 1, 1).normalized()).norm() <= 1e-13);
}

TEST_CASE("capsules lie on two points and stand on one") {
  const Capsule<double> lying{{V(-3, 0, 1), V(3, 0, 1)}, 1};
  const Box table{V(0, 0, -1), Matrix3<double>::Identity(), V(2, 2, 1)};
  const auto on_table = contact::contact_manifold(lying, table, 0.01);
  REQUIRE(on_table.points.size() == 2);
  CHECK(on_table.points[0].point == V(-2, 0, 0));
  CHECK(on_table.points[1].point == V(2, 0, 0));
  CHECK(on_table.normal == V(0, 0, 1));
  const auto on_floor = contact::contact_manifold(lying, floor_at_zero, 0.01);
  REQUIRE(on_floor.points.size() == 2);
  CHECK(on_floor.points[1].point == V(3, 0, 0));
  const Capsule<double> standing{{V(0, 0, 1), V(0.1, 0, 5)}, 1};
  CHECK(contact::contact_manifold(standing, floor_at_zero, 0.01).points.size() == 1);
  CHECK(contact::contact_manifold(standing, table, 0.01).points.size() == 1);
  const Capsule<double> above{{V(-1, 0, 3), V(9, 0, 3)}, 1};
  const auto pair = contact::contact_manifold(above, lying, 0.0);
  REQUIRE(pair.points.size() == 2);
  CHECK(pair.points[0].point == V(-1, 0, 2));
  CHECK(pair.points[1].point == V(3, 0, 2));
  CHECK(pair.normal == V(0, 0, 1));
  const Capsule<double> crossing{{V(0, -4, 3), V(0, 4, 3)}, 1};
  CHECK(contact::contact_manifold(crossing, lying, 0.0).points.size() == 1);
  const Sphere<double> ball{V(0, 0, 3), 1};
  for (const auto& manifold :
       {contact::contact_manifold(ball, lying, 0.0), contact::contact_manifold(ball, table, 2.0),
        contact::contact_manifold(ball, floor_at_zero, 2.0),
        contact::contact_manifold(ball, Sphere<double>{V(0, 0, 0), 2}, 0.0)}) {
    REQUIRE(manifold.points.size() == 1);
    CHECK(manifold.normal == V(0, 0, 1));
  }
  CHECK(contact::contact_manifold(floor_at_zero, ball, 2.0).normal == V(0, 0, -1));
  CHECK(contact::contact_manifold(ball, floor_at_zero, 1.0).points.empty());
}

TEST_CASE("the direct solution is one, in fractions: complementarity, momentum, least energy") {
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
    // No other pushes leave less.
    for (int other = 0; other < 5; ++other) {
      std::vector<Rational> changed = *impulses;
      for (Rational& x : changed) {
        x += Rational(random.integer(-3, 3)) / 16;
        if (x < 0) x = 0;
      }
      CHECK(energy(after) <= energy(contact::after_normal_impulses(p.bodies, p.contacts, changed)));
    }
    // Between movable bodies, momentum and angular momentum stay.
    bool movable = true;
    for (const auto& c : p.contacts) movable = movable && c.a != 0 && c.b != 0;
    if (movable) {
      CHECK(momentum(after) == momentum(p.bodies));
      CHECK(turning(after) == turning(p.bodies));
    }
    // In any order of the contacts, the same velocities.
    auto turned = p;
    std::rotate(turned.contacts.begin(), turned.contacts.begin() + 1, turned.contacts.end());
    const auto again = contact::complementary_impulses(turned.bodies, turned.contacts);
    REQUIRE(again.has_value());
    const auto also = contact::after_normal_impulses(turned.bodies, turned.contacts, *again);
    for (std::size_t k = 0; k < after.size(); ++k) {
      CHECK(also[k].velocity == after[k].velocity);
      CHECK(also[k].spin == after[k].spin);
    }
  }
  CHECK(pushes > tried(100));
}

TEST_CASE("restitution at all contacts at once keeps or loses energy, in fractions") {
  Random random(1805);
  for (int i = 0; i < tried(100); ++i) {
    auto p = problem(random, 4, random.integer(1, 5));
    const Rational e = Rational(random.integer(0, 4)) / 4;
    for (auto& c : p.contacts) c.least_velocity = -e * contact::contact_velocity(p.bodies, c);
    const auto impulses = contact::complementary_impulses(p.bodies, p.contacts);
    REQUIRE(impulses.has_value());
    const auto after = contact::after_normal_impulses(p.bodies, p.contacts, *impulses);
    CHECK(energy(after) <= energy(p.bodies));
    if (e == 1) CHECK(energy(after) == energy(p.bodies));
  }
}

TEST_CASE("a table on four legs, and what has no answer") {
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
  CHECK(after[1].spin == Vector(0, 0, 0));
  bodies[1] = contact::immovable<Rational>({0, 0, 1}, {0, 0, -1}, {0, 0, 0});
  CHECK_FALSE(contact::complementary_impulses(bodies, legs).has_value());
  const std::vector<BodyContact<Rational>> many(13, legs[0]);
  CHECK(contains(refusal([&] { contact::complementary_impulses(bodies, many); }), "13 rows"));
}

TEST_CASE("without friction the sweeps end where the direct solution is") {
  // A sweep changes no velocity by more than 1e-13 at the end. How far that is from the answer
  // depends on how fast the sweeps converge: each takes out at least a ten thousandth of the error
  // in all of these problems, so 1e-9 and a little.
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
    CHECK(got.report.last_change <= 1e-13);
    for (std::size_t k = 0; k < right.size(); ++k) {
      CHECK(oracle::error(got.bodies[k].velocity, right[k].velocity) <= 2e-9);
      CHECK(oracle::error(got.bodies[k].spin, right[k].spin) <= 2e-9);
    }
  }
}

TEST_CASE("what sweeps have left is finished to the direct solution, with masses 1 to a million") {
  // Every other body is 2^20 times as heavy. Sweeps would take millions to bring a light one
  // between two heavy ones to rest; elimination is told by none of them, or by a few. Velocities of
  // the heavy ones come with impulses a million times those of the light ones: what is rounded
  // there is 2^20 u of them, and a few.
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
      const auto got = contact::finish_contacts<double>(d.bodies, d.contacts, start);
      REQUIRE(got.has_value());
      for (std::size_t k = 0; k < right.size(); ++k) {
        CHECK(oracle::error(got->bodies[k].velocity, right[k].velocity) <= 1e-7);
        CHECK(oracle::error(got->bodies[k].spin, right[k].spin) <= 1e-7);
      }
    }
  }
}

TEST_CASE("a light ball between two a million times as heavy: a million sweeps are not enough") {
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
  const auto got = contact::finish_contacts<double>(bodies, contacts, swept.impulses);
  REQUIRE(got.has_value());
  for (const auto& c : contacts) CHECK(contact::contact_velocity(got->bodies, c) > -1e-9);
}

TEST_CASE(
    "a row of light balls between heavy ones: sweeps do not come to an end, elimination does") {
  // One half of the row comes at the other. All contacts are touched, and those that close leave as
  // fast as they came: no energy is lost.
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
    c.least_velocity = -contact::contact_velocity(bodies, c);
    contacts.push_back(c);
  }
  const auto swept = contact::solve_contacts<double>(bodies, contacts, {}, {100, 1e-7});
  CHECK(swept.report.last_change > 1e-3);
  const auto got = contact::finish_contacts<double>(bodies, contacts, swept.impulses);
  REQUIRE(got.has_value());
  CHECK(std::abs(energy(got->bodies) / energy(bodies) - 1) < 1e-9);
  for (const auto& c : contacts)
    CHECK(contact::contact_velocity(got->bodies, c) >= c.least_velocity - 1e-7);
}

TEST_CASE("what stands under a great weight is finished, as near to rest as its report says") {
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
    const auto got = contact::finish_contacts<double>(bodies, contacts, swept.impulses);
    REQUIRE(got.has_value());
    CHECK(got->report.rounding < weight * 1e-11);
    for (const auto& c : contacts)
      CHECK(std::abs(contact::contact_velocity(got->bodies, c)) <=
            std::max(1e-10, got->report.rounding));
  }
}

TEST_CASE("what is finished closes no faster, makes no energy, and rubs within its cone") {
  Random random(1817);
  int finished = 0;
  for (int i = 0; i < tried(400); ++i) {
    auto p = down(problem(random, random.integer(3, 8), random.integer(2, 14)));
    for (std::size_t k = 1; k < p.bodies.size(); k += 2) make_heavier(p.bodies[k], 0x1p12);
    const double e = i % 2 == 0 ? 0.0 : random.uniform(0, 1);
    for (auto& c : p.contacts) {
      c.friction = random.uniform(0, 1.5);
      c.least_velocity = std::max(0.0, -e * contact::contact_velocity(p.bodies, c));
    }
    const auto swept = contact::solve_contacts<double>(p.bodies, p.contacts, {}, {10, 0.0});
    const auto got = contact::finish_contacts<double>(p.bodies, p.contacts, swept.impulses);
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
      before = std::max(before, c.least_velocity - contact::contact_velocity(swept.bodies, c));
      after = std::max(after, c.least_velocity - contact::contact_velocity(got->bodies, c));
    }
    const double rounding = std::min(got->report.rounding, contact::most_rounding * fastest);
    if (!got->report.blended) CHECK(after <= before + std::max(0x1p-25 * fastest, rounding));
  }
  CHECK(finished > tried(400) / 2);
}

TEST_CASE("what is finished obeys Coulomb's law: friction is against the slip, or nothing slips") {
  // Velocities are as right as 2^14 roundings of what has been added up for them, 64 times what the
  // report counts; impulses to 2^14 u of the largest.
  Random random(1818);
  int finished = 0;
  int slides = 0;
  for (int i = 0; i < tried(150); ++i) {
    auto p = down(problem(random, random.integer(3, 8), random.integer(2, 12)));
    for (std::size_t k = 1; k < p.bodies.size(); k += 2)
      make_heavier(p.bodies[k], i % 2 == 0 ? 0x1p10 : 0x1p20);
    for (auto& c : p.contacts) c.friction = random.uniform(0, 1);
    const auto swept = contact::solve_contacts<double>(p.bodies, p.contacts, {}, {100, 0.0});
    const auto got = contact::finish_contacts<double>(p.bodies, p.contacts, swept.impulses);
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
      // It takes as much energy as any friction in its cone can.
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

TEST_CASE("friction that is only kept in its cones makes no energy, and lets nothing close") {
  Random random(1819);
  int finished = 0;
  for (int i = 0; i < tried(100); ++i) {
    auto p = down(problem(random, random.integer(3, 6), random.integer(2, 6)));
    for (std::size_t k = 1; k < p.bodies.size(); k += 2) make_heavier(p.bodies[k], 0x1p10);
    for (auto& c : p.contacts) c.friction = random.uniform(0, 1);
    const std::vector<ContactImpulse<double>> none(p.contacts.size());
    const auto got =
        contact::finish_contacts<double>(p.bodies, p.contacts, none, contact::FrictionLaw::cones);
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

TEST_CASE("plates on a slope are finished to rest, or to one speed, whatever lies on them") {
  for (const double load : {1.0, 1e3, 1e6}) {
    for (const double steep : {0.5, 0.99, 1.01, 2.0}) {  // times the friction angle's tangent
      CAPTURE(load, steep);
      // The slope is the plane of x and y here: g h is 1/6, of the angle whose tangent is steep/2.
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
      const auto got = contact::finish_contacts<double>(bodies, contacts, swept.impulses);
      REQUIRE(got.has_value());
      const double speed = std::max(0.0, free.x() + free.z() / 2);
      const double wrong = 64 * std::max(1e-12, got->report.rounding);
      CHECK((got->bodies[4].velocity - V(speed, 0, 0)).norm() <= wrong);
      CHECK(energy(got->bodies) <= energy(bodies));
      // What slides is at its limit on both faces: a plate may be anywhere between slope and load.
      for (std::size_t k = 1; k < 4; ++k) {
        const V v = got->bodies[k].velocity;
        CHECK(v.x() >= -wrong);
        CHECK(v.x() <= speed + wrong);
        CHECK((v - V(v.x(), 0, 0)).norm() <= wrong);
      }
    }
  }
}

TEST_CASE("what cannot be finished is left") {
  const std::vector<Body> walls(2, contact::immovable<double>({0, 0, 0}, {0, 0, 0}, {0, 0, 0}));
  BodyContact<double> c;
  c.a = 0;
  c.b = 1;
  c.normal = {1, 0, 0};
  CHECK_FALSE(contact::finish_contacts<double>(walls, {c}, {{}}).has_value());
  std::vector<Body> pair = walls;
  pair[0] = contact::rigid_body<double>(1, contact::sphere_inertia<double>(1, 1), {0, 0, 0},
                                        {0, 0, 0}, {0, 0, 0});
  const auto couplings = static_cast<double>(contact::most_couplings);
  const auto many = static_cast<std::size_t>(std::sqrt(couplings)) + 1;
  const std::vector<ContactImpulse<double>> none(many);
  CHECK_FALSE(contact::finish_contacts<double>(pair, std::vector(many, c), none).has_value());
  CHECK(contact::finish_contacts<double>(pair, {c}, {{}}).has_value());
}

TEST_CASE("after any number of sweeps nothing pulls, friction is in its cone, momentum stays") {
  Random random(1807);
  for (int i = 0; i < tried(600); ++i) {
    auto p = down(problem(random, random.integer(3, 6), random.integer(1, 8)));
    double friction = 0;
    for (auto& c : p.contacts) {
      c.friction = random.uniform(0, 1.5);
      c.least_velocity = random.uniform(-0.5, 2);
      friction = std::max(friction, c.friction);
    }
    const std::array<int, 4> counts{1, 2, 7, 300};
    const int sweeps = counts[static_cast<std::size_t>(i % 4)];
    const double relaxation = i % 3 == 0 ? 1.8 : 1.0;
    const auto got = contact::solve_contacts<double>(p.bodies, p.contacts, {},
                                                     {sweeps, 0.0, relaxation, random.chance(0.5)});
    double pushed = 0;
    for (std::size_t k = 0; k < p.contacts.size(); ++k) {
      const auto& x = got.impulses[k];
      CHECK(x.normal >= 0);
      CHECK(x.tangential.norm() <= p.contacts[k].friction * x.normal * (1 + 32 * u));
      CHECK(std::abs(x.tangential.dot(p.contacts[k].normal)) <= 32 * u * x.tangential.norm());
      pushed += x.normal * (1 + p.contacts[k].friction);
    }
    // Each impulse is divided by both masses and added to both velocities: a few roundings each, of
    // what was pushed and of what was there. Arms and coordinates are below 16 m here, and the
    // tensor and its inverse are not exactly inverse, by 1e2 u.
    double scale = pushed * 16;
    for (const Body& b : p.bodies) {
      scale += b.mass * b.velocity.norm() * 16 + (b.inertia * b.spin).norm();
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

TEST_CASE("contacts do not bring energy, with friction and restitution") {
  Random random(1808);
  int blended = 0;
  for (int i = 0; i < tried(400); ++i) {
    auto p = down(problem(random, random.integer(2, 5), random.integer(1, 6)));
    const double e = i % 2 == 0 ? 0.0 : random.uniform(0, 1);
    for (auto& c : p.contacts) {
      c.friction = random.uniform(0, 1.5);
      c.least_velocity = std::max(0.0, -e * contact::contact_velocity(p.bodies, c));
    }
    const auto got = contact::solve_contacts<double>(p.bodies, p.contacts, {},
                                                     {20000, 1e-12, 1.0, random.chance(0.5)});
    blended += got.report.blended ? 1 : 0;
    // What the velocities are off by, times the momenta.
    CHECK(energy(got.bodies) <= energy(p.bodies) * (1 + 1e-9));
  }
  CHECK(blended > tried(4));
}

TEST_CASE("no number of sweeps makes energy where nothing bounces") {
  Random random(1811);
  for (int i = 0; i < tried(400); ++i) {
    auto p = down(problem(random, random.integer(2, 5), random.integer(1, 8)));
    for (auto& c : p.contacts) {
      c.friction = random.uniform(0, 1.5);
      c.least_velocity = 0;
    }
    for (const int sweeps : {1, 2, 3, 10}) {
      const auto got =
          contact::solve_contacts<double>(p.bodies, p.contacts, {}, {sweeps, 0.0, 1.0, i % 2 == 0});
      CHECK(energy(got.bodies) <= energy(p.bodies) * (1 + 1e-12));
    }
  }
}

namespace {

/// A box that is its own mirror image across the plane of x and z, and moves in it, on a floor with
/// its four lower corners, in any order.
Problem<double> mirrored(Random& random) {
  Problem<double> p;
  const V half(random.uniform(0.2, 1), random.uniform(0.2, 1), random.uniform(0.2, 1));
  p.bodies = {contact::immovable<double>(V(0, 0, 0), V(0, 0, 0), V(0, 0, 0)),
              contact::rigid_body<double>(2, contact::box_inertia<double>(2, V(half * 2)),
                                          V(0, 0, half.z()),
                                          V(random.uniform(0.5, 3), 0, -random.uniform(0, 2)),
                                          V(0, random.uniform(-3, 3), 0))};
  const double friction = random.uniform(0.1, 0.8);
  const double e = random.uniform(0, 1);
  for (const double x : {-half.x(), half.x()})
    for (const double y : {-half.y(), half.y()})
      p.contacts.push_back({1, 0, V(x, y, 0), V(0, 0, 1), friction, 0});
  for (auto& c : p.contacts)
    c.least_velocity = std::max(0.0, -e * contact::contact_velocity(p.bodies, c));
  for (std::size_t k = 3; k > 0; --k)
    std::swap(p.contacts[k], p.contacts[static_cast<std::size_t>(random.integer(0, int(k)))]);
  return p;
}

}  // namespace

TEST_CASE("solved at once, a box that is its own mirror image stays so, in any order of contacts") {
  Random random(1812);
  for (int i = 0; i < tried(200); ++i) {
    const auto p = mirrored(random);
    const auto got =
        contact::solve_contacts<double>(p.bodies, p.contacts, {}, {20000, 1e-13, 1.0, true});
    const Body& box = got.bodies[1];
    CHECK(got.report.last_change <= 1e-13);
    CHECK(std::abs(box.velocity.y()) <= 1e-12);
    CHECK(std::abs(box.spin.x()) <= 1e-12);
    CHECK(std::abs(box.spin.z()) <= 1e-12);
  }
}

TEST_CASE("sweeps that go beyond a contact's answer settle with friction too") {
  Random random(1813);
  for (int i = 0; i < tried(200); ++i) {
    const auto p = mirrored(random);
    const auto got = contact::solve_contacts<double>(p.bodies, p.contacts, {}, {20000, 1e-13, 1.8});
    CHECK(got.report.last_change <= 1e-13);
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
    p.contacts[0].least_velocity = -e * velocity;
    const auto got = contact::solve_contacts(p.bodies, p.contacts);
    CHECK((got.bodies[static_cast<std::size_t>(c.a)].velocity - right.a.velocity).norm() <= 1e-12);
    CHECK((got.bodies[static_cast<std::size_t>(c.b)].spin - right.b.spin).norm() <= 1e-12);
  }
}

TEST_CASE(
    "who is light bounces off who is heavy, though the energy of the heavy one rounds to more") {
  // 5e17 J round to 64 J; the light one takes 2 J.
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
    contact.least_velocity = 1000;
    contacts.push_back(contact);
  }
  const auto solved = contact::solve_contacts<double>(bodies, contacts);
  CHECK_FALSE(solved.report.blended);
  CHECK(std::abs(solved.bodies[1].velocity.x() - 2000) < 1e-9);
}

TEST_CASE("ten boxes on a floor stay where they are for ten seconds") {
  std::vector<contact::ShapedBody<double>> bodies{contact::ground<double>({V(0, 0, 1), 0})};
  for (int i = 0; i < 10; ++i) {
    bodies.push_back(contact::solid_box<double>(1, V(1, 1, 1), V(0, 0, 0.5 + i)));
  }
  for (auto& body : bodies) body.friction = 0.5;
  const auto first = bodies;
  contact::StepMemory<double> memory;
  double moved = 0;
  double lowest = 0;
  for (int step = 0; step < tried(600); ++step) {
    contact::step_contacts(bodies, memory);
    for (std::size_t i = 1; i < bodies.size(); ++i) {
      moved = std::max(moved, (bodies[i].motion.position - first[i].motion.position).norm());
      moved = std::max(moved, bodies[i].orientation.v.norm());
    }
    for (const auto& impulse : memory.impulses) lowest = std::min(lowest, impulse.normal);
  }
  CAPTURE(moved);
  CHECK(moved < 1e-8);
  CHECK(lowest == 0);
  // The floor carries all of them: ten kilograms for a sixtieth of a second.
  double carried = 0;
  for (std::size_t i = 0; i < memory.contacts.size(); ++i) {
    if (memory.contacts[i].a == 0) carried += memory.impulses[i].normal;
  }
  CHECK(std::abs(carried - 10 * 9.80665 / 60) < 1e-8);
}

TEST_CASE("a box on a slope rests or slides as the angle says") {
  // tan of the angle is 3/4: it rests for μ = 0.8, and slides for 0.5 with g (0.6 − 0.5·0.8).
  const V up(-0.6, 0, 0.8);
  const Matrix3<double> axes = (Matrix3<double>() << 0.8, 0, -0.6, 0, 1, 0, 0.6, 0, 0.8).finished();
  // The sweeps of a step end at changes of 1e-11; with at least a ten thousandth of the error taken
  // out in each, sixty steps are off by less than 60 · 1e-7.
  for (const double friction : {0.8, 0.5}) {
    std::vector<contact::ShapedBody<double>> bodies{contact::ground<double>({up, 0})};
    bodies.push_back(contact::solid_box<double>(2, V(2, 2, 1), V(up * 0.5)));
    // A half turn of the slope's angle: its cosine is 3/√10.
    bodies[1].orientation = contact::normalised(contact::Rotor<double>{3, V(0, -1, 0)});
    bodies[1].motion = contact::rigid_body_from_axes<double>(
        2, bodies[1].moments, contact::matrix_of(bodies[1].orientation), V(up * 0.5), V(0, 0, 0),
        V(0, 0, 0));
    CHECK((contact::matrix_of(bodies[1].orientation) - axes).cwiseAbs().maxCoeff() < 8 * u);
    for (auto& body : bodies) body.friction = friction;
    contact::StepMemory<double> memory;
    for (int step = 0; step < 60; ++step) contact::step_contacts(bodies, memory);
    const double speed = friction == 0.8 ? 0.0 : 9.80665 * (0.6 - 0.5 * 0.8);
    CHECK((bodies[1].motion.velocity - V(-0.8, 0, -0.6) * speed).norm() < 6e-6);
    CHECK(bodies[1].motion.spin.norm() < 6e-6);
  }
}

TEST_CASE("the same start gives the same bits, and a ball rolls, bounces and comes to rest") {
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
  const V contact_speed = one[3].motion.velocity + one[3].motion.spin.cross(V(0, 0, -0.5));
  CHECK(contact_speed.norm() < 1e-6);
  CHECK(std::abs(one[3].motion.position.z() - 0.5) < 1e-3);
}

TEST_CASE("contacts that are none are refused, with the argument's name and value") {
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
