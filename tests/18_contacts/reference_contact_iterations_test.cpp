// contact_iterations.hpp: Jacobi keeps symmetry to the last bit, and over-relaxed iterations
// settle.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <contact/contact_iterations.hpp>
#include <contact/contact_solver.hpp>
#include <contact/symmetric_sum.hpp>
#include <vector>

#include "reference.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

using contact::BodyContact;
using contact::Matrix3;
using generators::Random;
using generators::tried;
using oracle::Rational;
using reference::Body;
using reference::down;
using reference::problem;
using reference::Problem;
using reference::V;

namespace {

/// The mirror image in the plane perpendicular to an axis.
V mirrored(V v, int axis) {
  v(axis) = -v(axis);
  return v;
}
/// The same of an angular velocity.
V mirrored_rotation(const V& v, int axis) { return -mirrored(v, axis); }
Matrix3<double> mirrored(Matrix3<double> m, int axis) {
  m.row(axis) = -m.row(axis);
  m.col(axis) = -m.col(axis);
  return m;
}

template <class T>
void shuffle(Random& random, std::vector<T>& list) {
  for (std::size_t k = list.size(); k > 1; --k)
    std::swap(list[k - 1], list[static_cast<std::size_t>(random.integer(0, int(k) - 1))]);
}

/// The mirror image of a problem, with its contacts in another order, half of them with A and B
/// exchanged.
Problem<double> mirrored(Random& random, Problem<double> p, int axis) {
  for (Body& b : p.bodies) {
    b.position = mirrored(b.position, axis);
    b.velocity = mirrored(b.velocity, axis);
    b.angular_velocity = mirrored_rotation(b.angular_velocity, axis);
    b.inertia = mirrored(b.inertia, axis);
    b.inverse_inertia = mirrored(b.inverse_inertia, axis);
  }
  for (auto& c : p.contacts) {
    c.point = mirrored(c.point, axis);
    c.normal = mirrored(c.normal, axis);
    if (random.chance(0.5)) continue;
    std::swap(c.a, c.b);
    c.normal = -c.normal;
  }
  shuffle(random, p.contacts);
  return p;
}

}  // namespace

TEST_CASE("with Jacobi the mirror image moves as the mirror image, to the last bit, in any order") {
  Random random(1812);
  for (int i = 0; i < tried(120); ++i) {
    auto p = down(problem(random, random.integer(2, 5), random.integer(2, 9)));
    const double e = i % 2 == 0 ? 0.0 : random.uniform(0, 1);
    for (auto& c : p.contacts) {
      c.friction = i % 3 == 0 ? 0.0 : random.uniform(0, 1);
      c.min_velocity = std::max(0.0, -e * contact::contact_velocity(p.bodies, c));
    }
    const int axis = random.integer(0, 2);
    const auto image = mirrored(random, p, axis);
    const int iterations = i % 10 == 0 ? 300 : random.integer(1, 30);
    const contact::SolverSettings<double> limits{iterations, 1e-12, 1.0, true};
    const auto one = contact::solve_contacts<double>(p.bodies, p.contacts, {}, limits);
    const auto two = contact::solve_contacts<double>(image.bodies, image.contacts, {}, limits);
    for (std::size_t k = 0; k < p.bodies.size(); ++k) {
      CHECK(two.bodies[k].velocity == mirrored(one.bodies[k].velocity, axis));
      CHECK(two.bodies[k].angular_velocity ==
            mirrored_rotation(one.bodies[k].angular_velocity, axis));
    }
    CHECK(one.report.iterations == two.report.iterations);
    CHECK(one.report.residual == two.report.residual);
  }
}

TEST_CASE("one after the other, the order of the contacts changes the bits") {
  Random random(1822);
  int changed = 0;
  for (int i = 0; i < tried(30); ++i) {
    const auto p = down(problem(random, 4, 6));
    const auto image = mirrored(random, p, 0);
    const contact::SolverSettings<double> limits{10, 0.0};
    const auto one = contact::solve_contacts<double>(p.bodies, p.contacts, {}, limits);
    const auto two = contact::solve_contacts<double>(image.bodies, image.contacts, {}, limits);
    changed += two.bodies[1].velocity == mirrored(one.bodies[1].velocity, 0) ? 0 : 1;
  }
  CHECK(changed > tried(15));
}

namespace {

/// A box that is symmetric about the plane of x and z, and moves in it, on a floor with its four
/// lower corners, in any order.
Problem<double> symmetric_box(Random& random) {
  Problem<double> p;
  const double x = random.uniform(0.2, 1);
  const double y = random.uniform(0.2, 1);
  const V half(x, y, random.uniform(0.2, 1));
  const double speed = random.uniform(0.5, 3);
  const V velocity(speed, 0, -random.uniform(0, 2));
  p.bodies = {
      contact::immovable<double>(V(0, 0, 0), V(0, 0, 0), V(0, 0, 0)),
      contact::rigid_body<double>(2, contact::box_inertia<double>(2, V(half * 2)),
                                  V(0, 0, half.z()), velocity, V(0, random.uniform(-3, 3), 0))};
  const double friction = random.uniform(0.1, 0.8);
  const double e = random.uniform(0, 1);
  for (const double px : {-half.x(), half.x()})
    for (const double py : {-half.y(), half.y()})
      p.contacts.push_back({1, 0, V(px, py, 0), V(0, 0, 1), friction, 0});
  for (auto& c : p.contacts)
    c.min_velocity = std::max(0.0, -e * contact::contact_velocity(p.bodies, c));
  shuffle(random, p.contacts);
  return p;
}

}  // namespace

TEST_CASE("with Jacobi a symmetric box stays symmetric to the last bit, and settles") {
  Random random(1823);
  for (int i = 0; i < tried(40); ++i) {
    const auto p = symmetric_box(random);
    const auto got =
        contact::solve_contacts<double>(p.bodies, p.contacts, {}, {20000, 1e-13, 1.0, true});
    const Body& box = got.bodies[1];
    CHECK(got.report.last_change <= 1e-13);
    CHECK((got.report.settled || got.report.blended));
    CHECK(box.velocity.y() == 0);
    CHECK(box.angular_velocity.x() == 0);
    CHECK(box.angular_velocity.z() == 0);
  }
}

TEST_CASE("over-relaxed iterations converge with friction too") {
  Random random(1813);
  for (int i = 0; i < tried(80); ++i) {
    const auto p = symmetric_box(random);
    const auto got = contact::solve_contacts<double>(p.bodies, p.contacts, {}, {20000, 1e-13, 1.8});
    CHECK(got.report.last_change <= 1e-13);
  }
}

TEST_CASE("a symmetric sum is the same in any order, reversed by reversed terms, and accurate") {
  Random random(1824);
  for (int i = 0; i < tried(1000); ++i) {
    std::vector<double> terms;
    const int count = random.integer(0, 40);
    const int range = random.integer(0, 90);
    const int middle = random.chance(0.1) ? -1040 : random.integer(-900, 900);
    for (int k = 0; k < count; ++k) {
      terms.push_back(random.magnitude(middle, middle + range));
      if (random.chance(0.3)) terms.push_back(-terms.back());
    }
    const double sum = contact::symmetric_sum(terms);
    Rational exact = 0;
    Rational largest = 0;
    for (const double x : terms) {
      exact += oracle::exact(x);
      largest = std::max(largest, Rational(abs(oracle::exact(x))));
    }
    const Rational n = Rational(static_cast<int>(terms.size()));
    const Rational unit = oracle::exact(reference::u);
    CHECK(abs(Rational(oracle::exact(sum) - exact)) <=
          unit * abs(exact) + 64 * n * n * n * unit * unit * largest + oracle::exact(0x1p-1074));
    auto other = terms;
    shuffle(random, other);
    CHECK(contact::symmetric_sum(other) == sum);
    for (double& x : other) x = -x;
    CHECK(contact::symmetric_sum(other) == -sum);
    std::vector<float> few;
    for (const double x : terms) few.push_back(static_cast<float>(std::ldexp(x, -middle)));
    const float single = contact::symmetric_sum(few);
    std::reverse(few.begin(), few.end());
    CHECK(contact::symmetric_sum(few) == single);
  }
}

TEST_CASE("a symmetric sum of huge terms does not overflow before it must") {
  CHECK(contact::symmetric_sum<double>({0x1p1023, -0x1p1023, 1}) == 1);
  CHECK(contact::symmetric_sum<double>({}) == 0);
}
