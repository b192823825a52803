// friction_pyramid.hpp: pyramid against cone, alone and in the iterations.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/contact_solver.hpp>
#include <contact/friction_pyramid.hpp>
#include <vector>

#include "reference.hpp"
#include "support/generators.hpp"

using contact::FrictionBound;
using generators::Random;
using generators::tried;
using reference::u;
using reference::V;

using V2 = contact::Vector2<double>;

TEST_CASE("sliding friction dissipates most of all that the bound allows") {
  Random random(1840);
  for (int i = 0; i < tried(2000); ++i) {
    const V2 slip{random.uniform(-1, 1), random.chance(0.2) ? 0.0 : random.uniform(-1, 1)};
    const double most = random.uniform(0, 2);
    for (const auto bound : {FrictionBound::cone, FrictionBound::pyramid}) {
      const V2 best = sliding_friction<double>(bound, slip, most);
      CHECK((bounded_friction<double>(bound, best, most) - best).norm() <= 4 * u * most);
      for (int k = 0; k < 5; ++k) {
        const V2 drawn{random.uniform(-3, 3), random.uniform(-3, 3)};
        const V2 other = bounded_friction<double>(bound, drawn, most);
        CHECK(best.dot(slip) <= other.dot(slip) + 8 * u * most);
      }
    }
  }
}

TEST_CASE("the pyramid is up to √2 too strong, and up to 45° off") {
  const double root = std::sqrt(2.0);
  const auto along = contact::pyramid_error<double>(V2(3, 0));
  CHECK(along.magnitude == 1);
  CHECK(along.cosine == 1);
  const auto diagonal = contact::pyramid_error<double>(V2(-2, 2));
  CHECK(std::abs(diagonal.magnitude - root) <= 4 * u);
  CHECK(std::abs(diagonal.cosine - 1) <= 4 * u);
  const auto beside = contact::pyramid_error<double>(V2(1, 1e-9));
  CHECK(std::abs(beside.magnitude - root) <= 4 * u);
  CHECK(std::abs(beside.cosine - 1 / root) <= 1e-9);
  Random random(1841);
  for (int i = 0; i < tried(1000); ++i) {
    const V2 slip{random.uniform(-1, 1), random.uniform(-1, 1)};
    const auto error = contact::pyramid_error<double>(slip);
    const double expected = (std::abs(slip.x()) + std::abs(slip.y())) / (root * slip.norm());
    CHECK(std::abs(error.cosine - expected) <= 16 * u);
    CHECK(error.cosine >= 1 / root - 8 * u);
  }
  CHECK(contact::pyramid_error<double>(V2(0, 0)).magnitude == 1);
}

TEST_CASE("friction and slip may be as large or as small as numbers can be") {
  const auto cone = FrictionBound::cone;
  const double half = std::sqrt(0.5);
  const V2 large = bounded_friction<double>(cone, V2(1.7e308, -1.7e308), 1);
  CHECK((large - V2(half, -half)).norm() <= 4 * u);
  CHECK(bounded_friction<double>(cone, V2(1.7e308, 1.7e308), 1.7e308).norm() > 0);
  CHECK(bounded_friction<double>(cone, V2(5e-324, 0), 0) == V2(0, 0));
  const double far = sliding_friction<double>(cone, V2(-1.7e308, 1.7e308), 1).x();
  CHECK(std::abs(far - half) <= 4 * u);
  // Slips of two and one times the smallest number.
  const auto small = contact::pyramid_error<double>(V2(1e-323, 5e-324));
  CHECK(std::abs(small.cosine - 3 / std::sqrt(10.0)) <= 8 * u);
  Random random(1843);
  for (int i = 0; i < tried(1000); ++i) {
    const V2 slip{double(random.integer(-9, 9)), double(random.integer(1, 9))};
    const auto right = contact::pyramid_error<double>(slip);
    const V2 friction = bounded_friction<double>(cone, slip * 0x1p-1074, 0x1p-1022);
    CHECK(friction == V2(slip * 0x1p-1074));  // inside the disc
    for (const double scale : {0x1p-1074, 0x1p-1000, 0x1p1000, 0x1p1020}) {
      const auto got = contact::pyramid_error<double>(V2(slip * scale));
      CHECK(std::abs(got.cosine - right.cosine) <= 8 * u);
      const V2 sliding = sliding_friction<double>(cone, V2(slip * scale), 1);
      CHECK((sliding - sliding_friction<double>(cone, slip, 1)).norm() <= 8 * u);
    }
  }
}

TEST_CASE("in the iterations the pyramid depends on the direction, and the cone does not") {
  // A body without rotation slides at an angle; the first tangent of this normal is along y.
  const auto speed_lost = [](FrictionBound bound, const V& slip) {
    contact::RigidBody<double> body;
    body.mass = body.inverse_mass = 1;
    body.velocity = slip + V(0, 0, -0.1);
    const std::vector<contact::RigidBody<double>> bodies{body, {}};
    contact::SolverSettings<double> limits;
    limits.friction_bound = bound;
    const auto got = contact::solve_contacts<double>(
        bodies, {{0, 1, V(0, 0, 0), V(0, 0, 1), 0.5, 0}}, {}, limits);
    CHECK(got.report.settled);
    return V(got.bodies[0].velocity - slip);
  };
  const double r = std::sqrt(0.5);
  for (const V& slip : {V(1, 0, 0), V(r, r, 0), V(-0.6, 0.8, 0)}) {
    const V cone = speed_lost(FrictionBound::cone, slip);
    CHECK((cone + slip * 0.05).norm() <= 1e-15);
    const V pyramid = speed_lost(FrictionBound::pyramid, slip);
    const double one = slip.x() > 0 ? -0.05 : 0.05;
    const double two = slip.y() > 0 ? -0.05 : slip.y() < 0 ? 0.05 : 0;
    CHECK((pyramid - V(one, two, 0)).norm() <= 1e-15);
  }
}

TEST_CASE("the pyramid adds no energy after any number of iterations either") {
  Random random(1842);
  for (int i = 0; i < tried(100); ++i) {
    auto p =
        reference::down(reference::problem(random, random.integer(2, 4), random.integer(1, 5)));
    for (auto& c : p.contacts) c.friction = random.uniform(0, 1.5);
    contact::SolverSettings<double> limits{random.integer(1, 40), 0.0};
    limits.friction_bound = FrictionBound::pyramid;
    limits.jacobi = random.chance(0.3);
    const auto got = contact::solve_contacts<double>(p.bodies, p.contacts, {}, limits);
    CHECK(reference::energy(got.bodies) <= reference::energy(p.bodies) * (1 + 1e-12));
    for (std::size_t k = 0; k < p.contacts.size(); ++k)
      CHECK(got.impulses[k].tangential.norm() <=
            std::sqrt(2.0) * p.contacts[k].friction * got.impulses[k].normal * (1 + 64 * u));
  }
}
