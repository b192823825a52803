// contact_energy.hpp: without restitution, no number of iterations adds energy, settled or not.
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/contact_energy.hpp>
#include <contact/contact_solver.hpp>
#include <vector>

#include "reference.hpp"
#include "support/generators.hpp"
#include "support/refusal.hpp"

using contact::BodyContact;
using contact::ContactImpulse;
using contact::RigidBody;
using generators::Random;
using generators::tried;
using reference::Body;
using reference::down;
using reference::energy;
using reference::problem;
using reference::Problem;
using reference::V;
using support::contains;
using support::refusal;

namespace {

struct CycleOfTwo {
  V size;
  V velocity;
  V angular_velocity;
  std::array<V, 2> points;
  std::array<V, 2> normals;
  std::array<double, 2> friction;
};

Problem<double> problem_of(const CycleOfTwo& from) {
  Problem<double> p;
  const V zero(0, 0, 0);
  p.bodies = {contact::immovable<double>(zero, zero, zero),
              contact::rigid_body<double>(1, contact::box_inertia<double>(1, from.size), zero,
                                          from.velocity, from.angular_velocity)};
  for (const std::size_t k : {0u, 1u})
    p.contacts.push_back({1, 0, from.points[k], from.normals[k], from.friction[k], 0});
  return p;
}

/// The energy that the iterations alone would have added, as a fraction.
double added_by_iterations(const Problem<double>& p, int iterations) {
  const auto prepared = contact::detail::prepared_contacts<double>(p.bodies, p.contacts);
  auto x = contact::detail::clamped_impulses<double>(prepared, {});
  contact::detail::iterate_until<double>(p.bodies, prepared, x, {iterations, 0.0});
  return energy(contact::detail::after_impulses(p.bodies, prepared, x)) / energy(p.bodies) - 1;
}

// Of millions of random sets of two contacts, those whose iterations repeat two states for ever,
// one of them with more energy than at the start.
const std::vector<CycleOfTwo> cycles{
    {{1, 0.7, 0.5},
     {0.8, 0.8, -0.6},
     {-0.6, -0.7, -1},
     {{{0.8, 0.1, 0.4}, {0.1, 0.9, 0.5}}},
     {{{0, 0, -1}, {0, 0.6, 0.8}}},
     {0.4, 1}},
    {{0.4, 0.3, 0.2},
     {0, 0.6, -0.7},
     {0.3, -0.8, 1},
     {{{-0.9, -0.5, 1}, {0.4, -0.5, -0.9}}},
     {{{0, -1, 0}, {0, -0.6, -0.8}}},
     {0.6, 1}},
    {{1, 0.2, 0.4},
     {0.4, 0.2, 0},
     {0.1, 0.9, 0},
     {{{0.2, 0.4, -0.2}, {0.2, -1, -1}}},
     {{{0, 0.6, 0.8}, {0, 0.6, 0.8}}},
     {0.9, 0.9}},
    {{0.3, 0.5, 0.5},
     {0.8, -0.7, -0.4},
     {-0.7, 0.8, 0.2},
     {{{-0.7, 0, 0.6}, {0.8, 0.2, 0.7}}},
     {{{0, 0, 1}, {0.6, 0, 0.8}}},
     {0.1, 1}},
    {{0.2, 0.4, 0.5},
     {-0.2, 0, 0.3},
     {0.9, -0.4, -0.4},
     {{{0.8, -0.9, -0.6}, {-0.2, -0.6, 0}}},
     {{{-0.8, -0.6, 0}, {0, -1, 0}}},
     {0.3, 0.9}},
    {{0.8, 0.9, 0.4},
     {-0.4, 0.4, 0.7},
     {0.7, 0.3, -0.2},
     {{{0.3, -0.7, 0.6}, {0.5, 0.4, 0.3}}},
     {{{0, -1, 0}, {0.8, 0.6, 0}}},
     {0.3, 1}},
    {{0.2, 0.3, 0.6},
     {-0.7, 0.7, -0.8},
     {-0.5, 0.7, -0.5},
     {{{0.6, 0.1, -1}, {-0.3, -0.8, -0.8}}},
     {{{0, -1, 0}, {0, -0.6, -0.8}}},
     {0.9, 0.7}},
    {{0.5, 0.7, 0.6},
     {-0.2, 0.6, 0.3},
     {0.2, -1, 0.8},
     {{{-0.6, 0.5, 0.5}, {0.3, 0.2, 0.9}}},
     {{{0, 0.8, -0.6}, {0.6, 0, 0.8}}},
     {0.3, 0.7}},
    {{0.2, 1, 0.3},
     {-0.2, 0, -0.1},
     {-0.3, 1, -0.5},
     {{{-0.3, 0, -0.2}, {-0.2, -0.5, -0.4}}},
     {{{0, 0.6, 0.8}, {0, -0.6, -0.8}}},
     {0.5, 0.9}},
};

}  // namespace

TEST_CASE("two contacts whose iterations repeat two states for ever add no energy") {
  for (const CycleOfTwo& cycle : cycles) {
    const auto p = problem_of(cycle);
    CHECK(added_by_iterations(p, 200) > 1e-4);
    for (const int iterations : {1, 2, 3, 40, 41, 200, 201, 1000}) {
      CAPTURE(iterations);
      const auto got = contact::solve_contacts<double>(p.bodies, p.contacts, {}, {iterations, 0.0});
      CHECK(energy(got.bodies) <= energy(p.bodies) * (1 + 1e-14));
      CHECK_FALSE(got.report.settled);
      CHECK(got.report.residual > 1e-3);
    }
    CHECK(contact::solve_contacts<double>(p.bodies, p.contacts, {}, {200, 0.0})
              .report.friction_reduced);
  }
}

TEST_CASE("the first pair of contacts has the energies of the report") {
  const auto p = problem_of(cycles[0]);
  CHECK(std::abs(energy(p.bodies) - 0.918704) < 5e-7);
  for (const int iterations : {100, 200, 1000})
    CHECK(std::abs(energy(p.bodies) * (1 + added_by_iterations(p, iterations)) - 0.919281) < 5e-7);
  // Many iterations reduce the relaxation, and then they settle.
  const auto got = contact::solve_contacts<double>(p.bodies, p.contacts, {}, {100000, 0.0});
  CHECK(energy(got.bodies) < energy(p.bodies));
  CHECK((!got.report.settled || got.report.residual < 1e-12));
}

TEST_CASE("iterations that repeat themselves settle when the relaxation is reduced") {
  for (const CycleOfTwo& cycle : cycles) {
    const auto p = problem_of(cycle);
    const auto got = contact::solve_contacts<double>(p.bodies, p.contacts);
    CHECK(got.report.settled);
    CHECK_FALSE(got.report.friction_reduced);
    CHECK(got.report.iterations > contact::detail::settling_iterations);
    CHECK(energy(got.bodies) <= energy(p.bodies));
  }
}

TEST_CASE("a cycle is not settled, however small its changes are") {
  // The first of the cycles, a million times slower: each change is smaller than the tolerance was
  // before, and the residual is still as large a part of the velocities.
  auto slow = cycles[0];
  slow.velocity *= 0x1p-20;
  slow.angular_velocity *= 0x1p-20;
  const auto p = problem_of(slow);
  const auto got = contact::solve_contacts<double>(p.bodies, p.contacts, {}, {500, 1e-12});
  CHECK(got.report.last_change < 1e-5);
  CHECK_FALSE(got.report.settled);
  CHECK(energy(got.bodies) <= energy(p.bodies) * (1 + 1e-14));
}

TEST_CASE("no warm start, no number of iterations and no relaxation adds energy") {
  Random random(1820);
  int reduced = 0;
  int settled = 0;
  for (int i = 0; i < tried(10000); ++i) {
    Problem<double> p;
    const V zero(0, 0, 0);
    p.bodies = {contact::immovable<double>(zero, zero, zero)};
    const auto drawn = [&] {
      const double x = random.uniform(-1, 1);
      const double y = random.uniform(-1, 1);
      return V(x, y, random.uniform(-1, 1));
    };
    const int bodies = random.integer(1, 2);
    for (int k = 0; k < bodies; ++k) {
      const V size = drawn().cwiseAbs() + V(0.1, 0.1, 0.1);
      const V x = drawn();
      const V v = drawn();
      const double mass = k == 0 ? 1 : random.uniform(0.01, 100);
      p.bodies.push_back(contact::rigid_body<double>(mass, contact::box_inertia<double>(mass, size),
                                                     x, v, drawn()));
    }
    std::vector<ContactImpulse<double>> start;
    const int contacts = random.integer(2, 3);
    for (int k = 0; k < contacts; ++k) {
      BodyContact<double> c{1, bodies == 2 && random.chance(0.5) ? 2 : 0, drawn(), zero, 0, 0};
      c.normal = drawn().normalized();
      c.friction = random.uniform(0, 1.5);
      c.min_velocity = random.chance(0.5) ? 0 : -random.uniform(0, 1);
      p.contacts.push_back(c);
      const double normal = random.uniform(0, 1);
      start.push_back({normal, drawn()});
    }
    if (random.chance(0.5)) start.clear();
    const int iterations = random.integer(1, 20);
    const double relaxation = random.uniform(0.5, 1.9);
    const auto got = contact::solve_contacts<double>(
        p.bodies, p.contacts, start, {iterations, 1e-9, relaxation, random.chance(0.3)});
    // The error of the energies: 64 ε of terms that the bound on impulses and velocities limits.
    CHECK(energy(got.bodies) <= energy(p.bodies) + 1e-12 * (1 + energy(p.bodies)));
    for (std::size_t k = 0; k < p.contacts.size(); ++k) {
      CHECK(got.impulses[k].normal >= 0);
      CHECK(got.impulses[k].tangential.norm() <=
            p.contacts[k].friction * got.impulses[k].normal * (1 + 64 * reference::u));
    }
    if (got.report.friction_reduced) CHECK_FALSE(got.report.settled);
    reduced += got.report.friction_reduced ? 1 : 0;
    settled += got.report.settled ? 1 : 0;
  }
  CAPTURE(reduced, settled);
  CHECK(reduced > tried(10));
  CHECK(settled > tried(1000));
}

TEST_CASE("what is called settled obeys complementarity and Coulomb's law") {
  Random random(1821);
  int settled = 0;
  for (int i = 0; i < tried(300); ++i) {
    auto p = down(problem(random, random.integer(2, 4), random.integer(1, 5)));
    for (auto& c : p.contacts) c.friction = random.uniform(0, 1);
    const double tolerance = 1e-10;
    const auto got = contact::solve_contacts<double>(
        p.bodies, p.contacts, {}, {i % 2 == 0 ? 30 : 5000, tolerance, 1.0, random.chance(0.2)});
    CHECK(got.report.settled == (got.report.residual <= tolerance + got.report.rounding));
    if (!got.report.settled) continue;
    ++settled;
    const double wrong = 2 * (tolerance + got.report.rounding);
    for (std::size_t k = 0; k < p.contacts.size(); ++k) {
      const auto& c = p.contacts[k];
      const auto& x = got.impulses[k];
      const V between = contact::velocity_at(got.bodies[static_cast<std::size_t>(c.a)], c.point) -
                        contact::velocity_at(got.bodies[static_cast<std::size_t>(c.b)], c.point);
      const double opening = c.normal.dot(between);
      const V slip = between - c.normal * opening;
      const double inverse_mass =
          contact::inverse_effective_mass_matrix<double>(p.bodies, {c})[0][0];
      CHECK(opening >= -wrong);
      CHECK((opening <= wrong || x.normal * inverse_mass <= wrong));
      if (c.friction == 0 || slip.norm() <= 64 * wrong) continue;
      // Sliding: the largest friction, opposite to the slip. An impulse that is wrong by a velocity
      // times the largest mass is wrong by that. The smallest inverse mass here is 1/4 kg⁻¹.
      const V opposite = -slip.normalized() * (c.friction * x.normal);
      CHECK((x.tangential - opposite).norm() <= 8 * wrong);
    }
  }
  CHECK(settled > tried(200));
}

TEST_CASE("two immovable bodies that close are not settled") {
  std::vector<Body> walls(2, contact::immovable<double>(V(0, 0, 0), V(0, 0, 0), V(0, 0, 0)));
  walls[0].velocity = V(0, 0, -2);
  const BodyContact<double> c{0, 1, V(0, 0, 0), V(0, 0, 1), 0.5, 0};
  const auto got = contact::solve_contacts<double>(walls, {c});
  CHECK_FALSE(got.report.settled);
  CHECK(got.report.residual == 2);
  CHECK(got.report.iterations == 1);
}

namespace {

/// A box of 2 m × 1 m × 1 m and 1 kg that falls onto a ground with some of its corners, with
/// restitution 1 and friction.
Problem<double> box_on_corners(Random& random) {
  Problem<double> p;
  const V zero(0, 0, 0);
  const double x = random.uniform(-1, 1);
  const double y = random.uniform(-1, 1);
  const V velocity(x, y, -random.uniform(0, 3));
  const double spin = random.uniform(-3, 3);
  const double tilt = random.uniform(-3, 3);
  p.bodies = {contact::immovable<double>(zero, zero, zero),
              contact::rigid_body<double>(1, contact::box_inertia<double>(1, V(2, 1, 1)),
                                          V(0, 0, 0.5), velocity, V(spin, tilt, -spin))};
  for (const double along : {-1.0, 1.0}) {
    for (const double across : {-0.5, 0.5}) {
      if (random.chance(0.4)) continue;
      BodyContact<double> c{1, 0, V(along, across, 0), V(0, 0, 1), random.uniform(0, 1), 0};
      c.min_velocity = std::max(0.0, -contact::velocity_at(p.bodies[1], c.point).z());
      p.contacts.push_back(c);
    }
  }
  return p;
}

double opening(const std::vector<Body>& bodies, const BodyContact<double>& c) {
  return c.normal.dot(contact::velocity_at(bodies[static_cast<std::size_t>(c.a)], c.point) -
                      contact::velocity_at(bodies[static_cast<std::size_t>(c.b)], c.point));
}

}  // namespace

TEST_CASE("settled and blended: a mixture of settled impulses, slower than the least velocities") {
  Random random(1822);
  int blended = 0;
  double slowest = 0;
  for (int i = 0; i < tried(1000); ++i) {
    const auto p = box_on_corners(random);
    const auto got = contact::solve_contacts<double>(p.bodies, p.contacts);
    CHECK(energy(got.bodies) <= energy(p.bodies) * (1 + 1e-11));
    if (!got.report.settled) continue;
    blended += got.report.blended ? 1 : 0;
    const double wrong = 2 * (1e-12 + got.report.rounding);
    for (const auto& c : p.contacts) {
      const double least = got.report.blended ? std::min(c.min_velocity, 0.0) : c.min_velocity;
      CHECK(opening(got.bodies, c) >= least - wrong);
      slowest = std::min(slowest, opening(got.bodies, c) - c.min_velocity);
    }
  }
  CHECK(blended > tried(50));
  CHECK(slowest < -0.1);  // so the least velocities are not reached
}

TEST_CASE("an immovable body that moves does not switch off the guard of restitution") {
  Random random(1823);
  int blended = 0;
  for (int i = 0; i < tried(500); ++i) {
    const auto p = box_on_corners(random);
    const auto right = contact::solve_contacts<double>(p.bodies, p.contacts);
    auto beside = p;  // another body far away, without a contact
    beside.bodies.push_back(
        contact::immovable<double>(V(1000, 0, 0), V(0, 0, 1e-9), V(0, 1e-9, 0)));
    const auto got = contact::solve_contacts<double>(beside.bodies, beside.contacts);
    CHECK(got.bodies[1].velocity == right.bodies[1].velocity);
    CHECK(got.report.blended == right.report.blended);
    blended += got.report.blended ? 1 : 0;
    // The ground moves, and the box with it: the same impact, and in its frame the same energy.
    const V speed(2, -1, 4);
    auto moving = p;
    for (auto& body : moving.bodies) body.velocity += speed;
    auto seen = contact::solve_contacts<double>(moving.bodies, moving.contacts);
    for (auto& body : seen.bodies) body.velocity -= speed;
    CHECK(energy(seen.bodies) <= energy(p.bodies) * (1 + 1e-12));
    CHECK((seen.bodies[1].velocity - right.bodies[1].velocity).norm() <= 1e-9);
  }
  CHECK(blended > tried(25));
}

TEST_CASE("a wall that hits a ball still gives it energy: restitution between moving walls") {
  Random random(1824);
  int closing = 0;
  for (int i = 0; i < tried(600); ++i) {
    // Each impulse times the mean (1 − e) v / 2 of its velocities is no gain if all contacts close,
    // so without friction nothing is reduced then, also at a wall that moves or turns.
    auto p = down(problem(random, 3, 0));
    p.bodies[0].velocity = V(0, 0, random.uniform(0, 3));
    p.bodies[0].angular_velocity = V(random.uniform(-1, 1), 0, 0);
    const double restitution = random.uniform(0, 1);
    bool all_close = true;
    for (int k = 0; k < 3; ++k) {
      const double x = random.uniform(-1, 1);
      BodyContact<double> c{k == 2 ? 2 : 1, k == 1 ? 2 : 0, V(x, 0.5, 0), V(0, 0, 1), 0, 0};
      c.min_velocity = std::max(0.0, -restitution * opening(p.bodies, c));
      p.contacts.push_back(c);
      all_close = all_close && c.min_velocity > 0;
    }
    if (!all_close) continue;
    ++closing;
    const auto got = contact::solve_contacts<double>(p.bodies, p.contacts);
    CHECK_FALSE(got.report.blended);
  }
  CHECK(closing > tried(20));
  std::vector<Body> bodies{
      contact::immovable<double>(V(0, 0, 0), V(0, 0, 3), V(0, 0, 0)),
      contact::rigid_body<double>(1, contact::box_inertia<double>(1, V(1, 1, 1)), V(0, 0, 0),
                                  V(0, 0, 0), V(0, 0, 0))};
  const auto hit = contact::solve_contacts<double>(bodies, {{1, 0, V(0, 0, 0), V(0, 0, 1), 0, 3}});
  CHECK(hit.bodies[1].velocity == V(0, 0, 6));
  CHECK_FALSE(hit.report.blended);
}

TEST_CASE("no impulse between two immovable bodies is kept from the start") {
  const V zero(0, 0, 0);
  const Body ground = contact::immovable<double>(zero, zero, zero);
  const Body lift = contact::immovable<double>(zero, V(0, 0, 1), zero);
  const BodyContact<double> pair{1, 0, zero, V(0, 0, 1), 0.5, 0};
  const auto alone = contact::solve_contacts<double>({ground, lift}, {pair}, {{1, V(0.1, 0, 0)}});
  CHECK(alone.report.settled);
  CHECK(alone.impulses[0].normal == 0);
  CHECK(alone.impulses[0].tangential == zero);
  // A box lands and slides beside: its friction is as without the pair.
  const Body box = contact::rigid_body<double>(1, contact::box_inertia<double>(1, V(1, 1, 1)), zero,
                                               V(2, 0, -1), zero);
  const BodyContact<double> landing{2, 0, zero, V(0, 0, 1), 0.5, 0};
  for (const double push : {0.0, 3.0, 10.0, 1000.0}) {
    const auto got = contact::solve_contacts<double>({ground, lift, box}, {pair, landing},
                                                     {{push, zero}, {0, zero}});
    CHECK(got.report.settled);
    CHECK_FALSE(got.report.friction_reduced);
    CHECK(std::abs(got.bodies[2].velocity.x() - 1.5) <= 1e-12);
  }
}

TEST_CASE("scales from 1e-150 to 1e150 give the same motion, and overflow is refused") {
  const auto scaled = [](double speed, double mass, int iterations) {
    auto p = problem_of(cycles[0]);
    const auto inertia = contact::box_inertia<double>(mass, cycles[0].size);
    p.bodies[1] = contact::rigid_body_from_axes<double>(
        mass, inertia.diagonal(), contact::Matrix3<double>::Identity(), V(0, 0, 0),
        V(cycles[0].velocity * speed), V(cycles[0].angular_velocity * speed));
    return contact::solve_contacts<double>(p.bodies, p.contacts, {}, {iterations, 0.0});
  };
  for (const int iterations : {1, 200, 5000}) {
    CAPTURE(iterations);
    const auto one = scaled(1, 1, iterations);
    const auto wrong = [&](double speed, double mass) {
      const V v = scaled(speed, mass, iterations).bodies[1].velocity / speed;
      return (v - one.bodies[1].velocity).norm();
    };
    // Small squares are computed with a scale, whose roundings differ.
    for (const double speed : {0x1p-498, 0x1p300}) CHECK(wrong(speed, 1) <= 1e-13);
    for (const double mass : {0x1p-498, 0x1p498}) CHECK(wrong(1, mass) <= 1e-13);
  }
  // Here energies underflow; the friction of iterations that settle is in its cone all the same.
  const V slow = scaled(0x1p-900, 1, 5000).bodies[1].velocity / 0x1p-900;
  CHECK((slow - scaled(1, 1, 5000).bodies[1].velocity).norm() <= 1e-13);
  CHECK(contains(refusal([&] { scaled(0x1p800, 0x1p498, 1); }), "overflow"));
}
