// Every reference function of the chapter: in fractions, where formulas and conservation laws hold
// without rounding, and in floating point against those fractions. u is the unit roundoff.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/impact_friction.hpp>
#include <contact/inertia.hpp>
#include <contact/rigid_body.hpp>
#include <contact/rigid_impulse.hpp>
#include <contact/rotation.hpp>
#include <limits>
#include <string>
#include <vector>

#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/refusal.hpp"

using contact::Closing;
using contact::ContactPoint;
using contact::Corners;
using contact::Matrix3;
using contact::RigidBody;
using contact::Vector3;
using generators::Random;
using oracle::Rational;
using oracle::Vector;
using support::contains;
using support::refusal;

namespace {

using Body = RigidBody<double>;
using Exactly = RigidBody<Rational>;
using Matrix = Matrix3<Rational>;
constexpr double u = 0x1p-53;

Rational fraction(Random& random) {
  return Rational(random.integer(-40, 40)) / random.integer(1, 9);
}
Rational positive(Random& random) { return Rational(random.integer(1, 40)) / random.integer(1, 9); }
Vector vector(Random& random) {
  const Rational x = fraction(random);
  const Rational y = fraction(random);
  return {x, y, fraction(random)};
}

/// A rotation with rational entries: that of a quaternion that need not have length 1.
Matrix rational_rotation(Random& random) {
  Rational w = random.integer(1, 5);
  const Vector v{Rational(random.integer(-5, 5)), Rational(random.integer(-5, 5)),
                 Rational(random.integer(-5, 5))};
  const Rational length = w * w + v.dot(v);
  Matrix m;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      m(i, k) = 2 * v(i) * v(k);
      if (i == k) m(i, k) += w * w - v.dot(v);
    }
  }
  m(0, 1) -= 2 * w * v(2);
  m(1, 0) += 2 * w * v(2);
  m(0, 2) += 2 * w * v(1);
  m(2, 0) -= 2 * w * v(1);
  m(1, 2) -= 2 * w * v(0);
  m(2, 1) += 2 * w * v(0);
  return m / length;
}

Exactly rational_body(Random& random) {
  const Vector size{positive(random), positive(random), positive(random)};
  const Rational mass = positive(random);
  const Matrix world = contact::rotated<Rational>(contact::box_inertia<Rational>(mass, size),
                                                  rational_rotation(random));
  const Vector x = vector(random);
  const Vector v = vector(random);
  return contact::rigid_body<Rational>(mass, world, x, v, vector(random));
}

/// A unit vector with rational coordinates.
Vector rational_direction(Random& random) { return rational_rotation(random).col(0); }

Vector3<double> direction(Random& random) {
  for (;;) {
    const Vector3<double> v{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    if (v.norm() > 0.1 && v.norm() <= 1) return v.normalized();
  }
}

Body body(Random& random, double mass) {
  const Vector3<double> moments{mass * random.uniform(0.1, 2), mass * random.uniform(0.1, 2),
                                mass * random.uniform(0.1, 2)};
  const auto turn =
      contact::exponential<double>(Vector3<double>(direction(random) * random.uniform(0, 3)));
  const Vector3<double> x{random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2)};
  const Vector3<double> v{random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-5, 5)};
  const Vector3<double> w{random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)};
  return contact::rigid_body_from_axes<double>(mass, moments, contact::matrix_of(turn), x, v, w);
}

Matrix exact_matrix(const Matrix3<double>& m) {
  Matrix e;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) e(i, k) = oracle::exact(m(i, k));
  }
  return e;
}
Exactly exactly(const Body& b) {
  return {oracle::exact(b.mass),         exact_matrix(b.inertia),
          oracle::exact(b.inverse_mass), exact_matrix(b.inverse_inertia),
          oracle::exact(b.position),     oracle::exact(b.velocity),
          oracle::exact(b.spin)};
}

Rational energy(const Body& a, const Body& b) {
  return contact::kinetic_energy(exactly(a)) + contact::kinetic_energy(exactly(b));
}

/// The Boole rule over [a, b]: exact for polynomials up to the fifth degree.
template <class F>
Rational integral(const F& f, const Rational& a, const Rational& b) {
  const Rational h = (b - a) / 4;
  return 2 * h / 45 *
         (7 * f(a) + 32 * f(Rational(a + h)) + 12 * f(Rational(a + 2 * h)) +
          32 * f(Rational(a + 3 * h)) + 7 * f(b));
}

const std::vector<Corners> box_triangles{{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6},
                                         {0, 1, 4}, {1, 5, 4}, {2, 6, 3}, {3, 6, 7},
                                         {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
std::vector<Vector> box_corners(const Vector& size, const Vector& centre, const Matrix& rotation) {
  std::vector<Vector> corners;
  for (int k = 0; k < 8; ++k) {
    const Vector c{(k & 1 ? 1 : -1) * size.x() / 2, (k & 2 ? 1 : -1) * size.y() / 2,
                   (k & 4 ? 1 : -1) * size.z() / 2};
    corners.push_back(centre + Vector(rotation * c));
  }
  return corners;
}

}  // namespace

TEST_CASE("shapes of revolution have the moments that slicing gives, in fractions") {
  // A slice at z is a disc of radius ρ: ½ dm ρ² about the axis, dm (ρ²/4 + z²) across. With a
  // density of 1/π a slice weighs ρ² dz; ρ² is a polynomial of z, so the integrals are exact.
  Random random(1701);
  for (int i = 0; i < 40; ++i) {
    const Rational r = positive(random);
    const Rational h = positive(random);
    const Rational half = h / 2;
    const auto inside = [&](const Rational&) { return Rational(r * r); };
    const auto cap = [&](const Rational& z) { return Rational(r * r - (z - half) * (z - half)); };
    const auto sum = [&](const auto& f, bool with_middle, bool with_caps) {
      Rational total = 0;
      if (with_middle) {
        total += integral([&](const Rational& z) { return f(inside(z), z); }, -half, half);
      }
      if (with_caps) {
        total +=
            2 * integral([&](const Rational& z) { return f(cap(z), z); }, half, Rational(half + r));
      }
      return total;
    };
    const auto weight = [](const Rational& s, const Rational&) { return s; };
    const auto along = [](const Rational& s, const Rational&) { return Rational(s * s / 2); };
    const auto across = [](const Rational& s, const Rational& z) {
      return Rational(s * (s / 4 + z * z));
    };
    const Matrix cylinder = contact::cylinder_inertia<Rational>(sum(weight, true, false), r, h);
    CHECK(cylinder(2, 2) == sum(along, true, false));
    CHECK(cylinder(0, 0) == sum(across, true, false));
    const Matrix capsule = contact::capsule_inertia<Rational>(sum(weight, true, true), r, h);
    CHECK(capsule(2, 2) == sum(along, true, true));
    CHECK(capsule(0, 0) == sum(across, true, true));
    CHECK(capsule(1, 1) == capsule(0, 0));
    // Without a middle it is a sphere.
    const Rational m = positive(random);
    CHECK(contact::capsule_inertia<Rational>(m, r, 0) == contact::sphere_inertia<Rational>(m, r));
    CHECK(contact::sphere_inertia<Rational>(m, r)(0, 0) == 2 * m * r * r / 5);
  }
}

TEST_CASE("a mesh of a box has the box's mass, centre and tensor, in fractions") {
  Random random(1702);
  for (int i = 0; i < 20; ++i) {
    const Vector size{positive(random), positive(random), positive(random)};
    const Rational density = positive(random);
    const Vector centre = vector(random);
    const Matrix turn = rational_rotation(random);
    const auto got =
        contact::mesh_mass<Rational>(density, box_corners(size, centre, turn), box_triangles);
    REQUIRE(got.has_value());
    CHECK(got->mass == density * size.x() * size.y() * size.z());
    CHECK(got->centre == centre);
    const Matrix right =
        contact::rotated<Rational>(contact::box_inertia<Rational>(got->mass, size), turn);
    CHECK(got->inertia == right);
    // A box's moment about x by integration over y and z.
    const Rational by_hand = density * size.x() *
                             (size.z() * integral([](const Rational& y) { return Rational(y * y); },
                                                  -size.y() / 2, size.y() / 2) +
                              size.y() * integral([](const Rational& z) { return Rational(z * z); },
                                                  -size.z() / 2, size.z() / 2));
    CHECK(contact::box_inertia<Rational>(got->mass, size)(0, 0) == by_hand);
  }
  // Inside out, flat, or nothing at all.
  std::vector<Corners> reversed = box_triangles;
  for (Corners& corners : reversed) std::swap(corners[0], corners[1]);
  const auto corners = box_corners({1, 1, 1}, {0, 0, 0}, Matrix::Identity());
  CHECK_FALSE(contact::mesh_mass<Rational>(1, corners, reversed).has_value());
  CHECK_FALSE(contact::mesh_mass<Rational>(1, box_corners({1, 1, 0}, {0, 0, 0}, Matrix::Identity()),
                                           box_triangles)
                  .has_value());
  CHECK_FALSE(contact::mesh_mass<Rational>(1, corners, {}).has_value());
}

TEST_CASE("a mesh far from the origin keeps the digits that its corners have") {
  Random random(1703);
  for (int i = 0; i < 20; ++i) {
    const Vector3<double> far{random.magnitude(20, 24), random.magnitude(20, 24), 0};
    std::vector<Vector3<double>> vertices;
    std::vector<Vector> stored;
    for (const Vector& corner : box_corners({2, 3, 1}, Vector::Zero(), Matrix::Identity())) {
      vertices.push_back(far + oracle::nearest(corner));
      stored.push_back(oracle::exact(vertices.back()));
    }
    const auto got = contact::mesh_mass<double>(1, vertices, box_triangles);
    const auto right = contact::mesh_mass<Rational>(1, stored, box_triangles);
    REQUIRE(got.has_value());
    for (int k = 0; k < 3; ++k) {
      CHECK(oracle::error(got->inertia(k, k), right->inertia(k, k)) <= 1e-13);
      // γ(22) of the sizes of twelve tetrahedra about a point near the centre, a few times the
      // tensor's own size of 6.5; and the centre to the spacing of doubles there.
      CHECK(oracle::error(got->centre(k), right->centre(k)) <= 0x1p-28);
    }
  }
}

TEST_CASE("the parallel-axis theorem, and parts fixed together, in fractions") {
  Random random(1704);
  for (int i = 0; i < 40; ++i) {
    // Two boxes end to end are one box.
    const Vector size{positive(random), positive(random), positive(random)};
    const Rational mass = positive(random);
    const Rational share = Rational(random.integer(1, 9)) / 10;
    const Rational left = size.x() * share;
    const Rational right = size.x() - left;
    const Vector corner = vector(random);
    const auto part = [&](const Rational& length, const Rational& start) {
      const Rational m = mass * length / size.x();
      return contact::MassProperties<Rational>{
          m, corner + Vector(start + length / 2, 0, 0),
          contact::box_inertia<Rational>(m, {length, size.y(), size.z()})};
    };
    const auto whole = contact::together<Rational>({part(left, 0), part(right, left)});
    REQUIRE(whole.has_value());
    CHECK(whole->mass == mass);
    CHECK(whole->centre == corner + Vector(size.x() / 2, 0, 0));
    CHECK(whole->inertia == contact::box_inertia<Rational>(mass, size));
    // m |ω × d|² is the energy that the moved mass adds.
    const Vector d = vector(random);
    const Vector w = vector(random);
    const Vector moved = Vector(w.cross(d));
    const Vector added = contact::parallel_axis<Rational>(mass, d) * w;
    CHECK(w.dot(added) == mass * moved.dot(moved));
  }
  CHECK_FALSE(contact::together<double>({}).has_value());
}

TEST_CASE("principal axes give the tensor back") {
  Random random(1705);
  for (int i = 0; i < 400; ++i) {
    Vector3<double> moments{std::abs(random.magnitude(-20, 20)),
                            std::abs(random.magnitude(-20, 20)),
                            std::abs(random.magnitude(-20, 20))};
    if (random.chance(0.3)) moments.y() = moments.x();
    const Matrix3<double> turn = contact::matrix_of(
        contact::exponential<double>(Vector3<double>(direction(random) * random.uniform(0, 3))));
    const Matrix3<double> inertia = contact::rotated<double>(moments.asDiagonal(), turn);
    const auto got = contact::principal_axes<double>(inertia);
    const double largest = moments.maxCoeff();
    // At most 12 rounds of three rotations, each a few roundings of the largest entry.
    const double room = 400 * u * largest;
    const Matrix3<double> again = contact::rotated<double>(got.moments.asDiagonal(), got.rotation);
    CHECK((again - inertia).cwiseAbs().maxCoeff() <= room);
    CHECK((got.rotation.transpose() * got.rotation - Matrix3<double>::Identity())
              .cwiseAbs()
              .maxCoeff() <= 400 * u);
    CHECK(got.rotation.determinant() > 0);
    CHECK((got.moments.x() <= got.moments.y() && got.moments.y() <= got.moments.z()));
  }
}

TEST_CASE("a frictionless collision keeps all that it must, in fractions") {
  Random random(1706);
  int met = 0;
  int grounded = 0;
  for (int i = 0; i < 300; ++i) {
    const Exactly a = rational_body(random);
    Exactly b = rational_body(random);
    const bool against_moving = i % 5 == 0;
    const bool against_ground = i % 5 == 1;
    if (against_moving) b = contact::immovable<Rational>(b.position, b.velocity, b.spin);
    if (against_ground) {
      b = contact::immovable<Rational>(b.position, Vector(0, 0, 0), Vector(0, 0, 0));
    }
    const ContactPoint<Rational> at{vector(random), rational_direction(random)};
    REQUIRE(Rational(at.normal.dot(at.normal)) == 1);
    const Rational e = Rational(random.integer(0, 10)) / 10;
    const Rational before = contact::normal_velocity(a, b, at);
    const auto [a2, b2, impulse] = contact::collide<Rational>(a, b, at, e);
    if (!(before < 0)) {
      CHECK(impulse == Vector(0, 0, 0));
      CHECK(contact::collision_impulse<Rational>(a, b, at, e) == 0);
      continue;
    }
    ++met;
    CHECK(contact::normal_velocity(a2, b2, at) == -e * before);
    CHECK(contact::collision_impulse<Rational>(a, b, at, e) > 0);
    const Rational k0 = contact::kinetic_energy(a) + contact::kinetic_energy(b);
    const Rational k1 = contact::kinetic_energy(a2) + contact::kinetic_energy(b2);
    if (!against_ground && !against_moving) {
      CHECK(Vector(a.velocity * a.mass + b.velocity * b.mass) ==
            Vector(a2.velocity * a2.mass + b2.velocity * b2.mass));
      const Vector o = vector(random);
      CHECK(Vector(contact::angular_momentum(a, o) + contact::angular_momentum(b, o)) ==
            Vector(contact::angular_momentum(a2, o) + contact::angular_momentum(b2, o)));
    }
    // What moves and cannot be moved does work; the ground does none.
    if (!against_moving) {
      grounded += against_ground;
      CHECK(k1 <= k0);
      // What is lost is ½ (1 − e²) v_n² / k, with k the response along n.
      const Rational k = contact::response<Rational>(a, b, at.point, at.normal, at.normal);
      CHECK(k0 - k1 == (1 - e * e) * before * before / k / 2);
    }
  }
  CHECK(met > 100);
  CHECK(grounded > 20);
}

TEST_CASE("the response is what one unit of impulse does") {
  Random random(1707);
  for (int i = 0; i < 100; ++i) {
    const Exactly a = rational_body(random);
    const Exactly b = rational_body(random);
    const Vector p = vector(random);
    const Vector in = vector(random);
    const Vector out = vector(random);
    const auto relative = [&](const Exactly& x, const Exactly& y) {
      return Vector(contact::velocity_at(x, p) - contact::velocity_at(y, p));
    };
    const Vector change = relative(contact::after_impulse<Rational>(a, in, p),
                                   contact::after_impulse<Rational>(b, Vector(-in), p)) -
                          relative(a, b);
    CHECK(contact::response<Rational>(a, b, p, out, in) == out.dot(change));
    CHECK(contact::response<Rational>(a, b, p, in, out) ==
          contact::response<Rational>(a, b, p, out, in));
  }
}

TEST_CASE("through the centres, a collision is one without rotation") {
  Random random(1708);
  for (int i = 0; i < 100; ++i) {
    Exactly a = rational_body(random);
    Exactly b = rational_body(random);
    const Vector n = rational_direction(random);
    const ContactPoint<Rational> at{b.position + n * positive(random), n};
    a.position = at.point + n * positive(random);
    const auto [a2, b2, impulse] = contact::collide<Rational>(a, b, at, Rational(1) / 2);
    CHECK(a2.spin == a.spin);
    CHECK(b2.spin == b.spin);
    CHECK(impulse ==
          Vector(n * contact::impulse_without_rotation<Rational>(a, b, at, Rational(1) / 2)));
  }
}

TEST_CASE("in floating point a collision keeps momentum to rounding, and e") {
  Random random(1709);
  int met = 0;
  int grounded = 0;
  for (int i = 0; i < 1500; ++i) {
    const Body a = body(random, std::ldexp(random.uniform(1, 2), random.integer(-40, 40)));
    Body b = body(random, std::ldexp(random.uniform(1, 2), random.integer(-40, 40)));
    if (i % 7 == 0) b = contact::immovable<double>(b.position, b.velocity, b.spin);
    const bool ground = i % 7 == 1;
    if (ground) {
      b = contact::immovable<double>(b.position, Vector3<double>::Zero(), Vector3<double>::Zero());
    }
    const ContactPoint<double> at{{random.uniform(-2, 2), random.uniform(-2, 2), 0},
                                  direction(random)};
    const double e = random.uniform();
    const auto [a2, b2, impulse] = contact::collide<double>(a, b, at, e);
    if (contact::closing_case(a, b, at) != Closing::approaching) {
      CHECK((a2.velocity == a.velocity && b2.spin == b.spin));
      continue;
    }
    ++met;
    // Each coordinate of v' is rounded in j/m and in the sum, and 1/m before: 4 u of m|v| + |J|.
    const auto size = [](const Body& x, const Body& y) {
      return x.mass * (x.velocity.cwiseAbs() + y.velocity.cwiseAbs()).sum();
    };
    if (b.mass > 0) {
      const Vector drift = oracle::exact(a2.velocity) * oracle::exact(a.mass) +
                           oracle::exact(b2.velocity) * oracle::exact(b.mass) -
                           oracle::exact(a.velocity) * oracle::exact(a.mass) -
                           oracle::exact(b.velocity) * oracle::exact(b.mass);
      const double scale = size(a, a2) + size(b, b2);
      for (int k = 0; k < 3; ++k) {
        CHECK(abs(drift(k)) <= oracle::exact(4 * u * scale));
      }
      const Vector3<double> o = Vector3<double>::Zero();
      const Vector twist = contact::angular_momentum(exactly(a2), oracle::exact(o)) +
                           contact::angular_momentum(exactly(b2), oracle::exact(o)) -
                           contact::angular_momentum(exactly(a), oracle::exact(o)) -
                           contact::angular_momentum(exactly(b), oracle::exact(o));
      // Σ|r||p|, the spins' own Iω, and the twists I I⁻¹ (r × J). The stored inverse is off by 20 u
      // of I⁻¹ (two products of three), that is by 20 u times I's ratio of at most 20 of r × J.
      const auto turning = [](const Body& x) {
        return x.position.norm() * x.mass * x.velocity.norm() + x.inertia.norm() * x.spin.norm();
      };
      const double arms = (at.point - a.position).norm() + (at.point - b.position).norm();
      const double angular =
          turning(a) + turning(a2) + turning(b) + turning(b2) + 20 * arms * impulse.norm();
      for (int k = 0; k < 3; ++k) CHECK(abs(twist(k)) <= oracle::exact(40 * u * angular));
    }
    if (b.mass > 0 || ground) {
      grounded += ground;
      CHECK(energy(a2, b2) <= energy(a, b) * (1 + oracle::exact(2000 * u)));
    }
    const double fast = contact::normal_velocity(a2, b2, at);
    const double right = -e * contact::normal_velocity(a, b, at);
    const auto speed = [&](const Body& x) {
      return x.velocity.norm() + x.spin.norm() * (at.point - x.position).norm();
    };
    CHECK(std::abs(fast - right) <= 200 * u * (speed(a) + speed(b) + speed(a2) + speed(b2)));
  }
  CHECK(met > 500);
  CHECK(grounded > 50);
}

TEST_CASE("bodies that collided do not close, however slowly they came") {
  // The spins and velocities are of the order of 10; what they close by is one digit of one of
  // them, a few digits of all, or what is left when the rest has cancelled.
  Random random(1717);
  int met = 0;
  for (int i = 0; i < 1200; ++i) {
    Body a = body(random, std::ldexp(random.uniform(1, 2), random.integer(-40, 40)));
    Body b = body(random, std::ldexp(random.uniform(1, 2), random.integer(-40, 40)));
    const bool ground = i % 5 == 0;
    if (ground) {
      b = contact::immovable<double>(b.position, Vector3<double>::Zero(), Vector3<double>::Zero());
    }
    ContactPoint<double> at{{random.uniform(-2, 2), random.uniform(-2, 2), 0}, direction(random)};
    if (i % 2 == 0) at.normal = Vector3<double>::UnitZ();
    a.velocity -= at.normal * contact::normal_velocity(a, b, at);
    if (i % 3 == 0) {
      a.velocity.z() = std::nextafter(a.velocity.z(), at.normal.z() > 0 ? -100. : 100.);
    }
    if (i % 3 == 1) a.velocity -= at.normal * (random.integer(1, 64) * u * a.velocity.norm());
    if (contact::closing_case(a, b, at) != Closing::approaching) continue;
    const double e = std::vector<double>{0, 0.1, 0.5, 1}[std::size_t(random.integer(0, 3))];
    const auto [a2, b2, impulse] = contact::collide<double>(a, b, at, e);
    ++met;
    const ContactPoint<Rational> exact_at{oracle::exact(at.point), oracle::exact(at.normal)};
    const Rational after = contact::normal_velocity(exactly(a2), exactly(b2), exact_at);
    REQUIRE(after >= 0);
    // The impulse is raised until v_n is not below 0, in steps that double: by at most three times
    // what the velocities are rounded by, as in the test above.
    const auto speed = [&](const Body& x) {
      return x.velocity.norm() + x.spin.norm() * (at.point - x.position).norm();
    };
    const Rational right =
        -oracle::exact(e) * contact::normal_velocity(exactly(a), exactly(b), exact_at);
    CHECK(abs(after - right) <=
          oracle::exact(600 * u * (speed(a) + speed(b) + speed(a2) + speed(b2))));
    // One impulse for both, whatever it is: momentum, and no energy made.
    if (!ground) {
      const Vector3<double> size = a.mass * (a.velocity.cwiseAbs() + a2.velocity.cwiseAbs()) +
                                   b.mass * (b.velocity.cwiseAbs() + b2.velocity.cwiseAbs());
      for (int k = 0; k < 3; ++k) {
        const Rational drift =
            oracle::exact(a.mass) * (oracle::exact(a2.velocity(k)) - oracle::exact(a.velocity(k))) +
            oracle::exact(b.mass) * (oracle::exact(b2.velocity(k)) - oracle::exact(b.velocity(k)));
        CHECK(abs(drift) <= oracle::exact(4 * u * size.sum()));
      }
    }
    CHECK(energy(a2, b2) <= energy(a, b) * (1 + oracle::exact(2000 * u)));
  }
  CHECK(met > 600);
}

TEST_CASE("a collision at the edge of overflow stays finite, and one at that of underflow parts") {
  for (const double speed : {0x1p1022, 0x1p-1070}) {
    for (const double e : {0.0, 0.5}) {
      Random random(1718);
      for (int i = 0; i < 50; ++i) {
        Body a = body(random, 1);
        Body b = body(random, 1);
        a.velocity *= speed / 8;
        b.velocity *= speed / 8;
        a.spin *= speed / 64;
        b.spin *= speed / 64;
        const ContactPoint<double> at{{random.uniform(-1, 1), random.uniform(-1, 1), 0},
                                      Vector3<double>::UnitZ()};
        const auto [a2, b2, impulse] = contact::collide<double>(a, b, at, e);
        for (const Body& x : {a2, b2}) CHECK((x.velocity.allFinite() && x.spin.allFinite()));
        if (!(impulse.norm() > 0) && speed < 1) continue;  // less than the smallest number
        if (speed < 1) CHECK(contact::closing_case(a2, b2, at) != Closing::approaching);
      }
    }
  }
}

TEST_CASE("the closing case is never wrong for the numbers as stored") {
  Random random(1710);
  int rescued = 0;
  for (int i = 0; i < 3000; ++i) {
    Body a = body(random, 1);
    Body b = body(random, 1);
    ContactPoint<double> at{{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)},
                            direction(random)};
    const int scale = random.integer(-3, 3) * 150;
    if (i % 2 == 0) {
      // Matched so that v_n is about 0: far below what plain arithmetic can tell.
      const Vector3<double> relative =
          contact::velocity_at(a, at.point) - contact::velocity_at(b, at.point);
      b.velocity += at.normal * at.normal.dot(relative);
    }
    for (Body* x : {&a, &b}) {
      for (int k = 0; k < 3; ++k) {
        x->velocity(k) = std::ldexp(x->velocity(k), scale);
        x->spin(k) = std::ldexp(x->spin(k), scale);
      }
    }
    const Rational right = contact::normal_velocity(
        exactly(a), exactly(b), {oracle::exact(at.point), oracle::exact(at.normal)});
    const auto got = contact::closing_case(a, b, at);
    const int sign = oracle::sign(right);
    REQUIRE(got == (sign < 0   ? Closing::approaching
                    : sign > 0 ? Closing::separating
                               : Closing::touching));
    const double plain =
        at.normal.dot(contact::velocity_at(a, at.point) - contact::velocity_at(b, at.point));
    rescued += (plain > 0) - (plain < 0) != sign;
    if (sign < 0 && oracle::nearest(right) < -1e-300) {
      CHECK(contact::collision_impulse<double>(a, b, at, 0.5) > 0);
    }
  }
  CHECK(rescued > 100);  // plain arithmetic has these wrong
}

TEST_CASE("a thin rod is a box whose other edges are nothing") {
  Random random(1716);
  for (int i = 0; i < 100; ++i) {
    const Rational length = positive(random);
    const Rational mass = positive(random);
    const Rational thin = positive(random);
    const Matrix box = contact::box_inertia<Rational>(mass, {length, thin, thin});
    CHECK(contact::rod_inertia<Rational>(mass, length) == box(1, 1) - mass * thin * thin / 12);
  }
  CHECK(contact::rod_inertia(3.0, 2.0) == 1);
  CHECK_THROWS_AS(contact::rod_inertia(0.0, 1.0), std::invalid_argument);
  CHECK_THROWS_AS(contact::rod_inertia(1.0, -1.0), std::invalid_argument);
}

TEST_CASE("a hit at the centre of percussion leaves the other end where it is") {
  Random random(1711);
  for (int i = 0; i < 100; ++i) {
    const Rational length = positive(random);
    const Rational mass = positive(random);
    const Rational inertia = contact::rod_inertia<Rational>(mass, length);
    const Rational d = length / 2;
    const Rational beyond = contact::centre_of_percussion<Rational>(inertia, mass, d);
    CHECK(beyond == length / 6);  // two thirds of the rod from the end that is held
    const Exactly rod = contact::rigid_body<Rational>(
        mass, contact::detail::diagonal<Rational>(1, inertia, inertia), {0, 0, 0}, {0, 0, 0},
        {0, 0, 0});
    const auto hit =
        contact::after_impulse<Rational>(rod, {0, positive(random), 0}, {beyond, 0, 0});
    CHECK(contact::velocity_at(hit, Vector(-d, 0, 0)) == Vector(0, 0, 0));
  }
  CHECK(std::isinf(contact::centre_of_percussion(1.0, 2.0, 0.0)));
}

namespace {

contact::PlanarContact<Rational> random_contact(Random& random) {
  contact::PlanarContact<Rational> c;
  c.slip = random.chance(0.1) ? Rational(0) : fraction(random);
  c.normal = -positive(random);
  c.k_tt = positive(random);
  c.k_nn = positive(random);
  do {
    c.k_tn = fraction(random) / 4;
  } while (!(c.k_tn * c.k_tn < c.k_tt * c.k_nn));
  return c;
}

/// What every path must hold to: velocities follow impulses, and Coulomb's law at each piece.
void check_path(const contact::PlanarContact<Rational>& c, const contact::Impact<Rational>& impact,
                const Rational& friction) {
  for (std::size_t i = 0; i < impact.count; ++i) {
    const auto& p = impact.path[i];
    REQUIRE(p.slip == c.slip + c.k_tt * p.tangential + c.k_tn * p.impulse);
    REQUIRE(p.normal == c.normal + c.k_tn * p.tangential + c.k_nn * p.impulse);
    if (i == 0) continue;
    const auto& q = impact.path[i - 1];
    const Rational dn = p.impulse - q.impulse;
    const Rational dt = p.tangential - q.tangential;
    REQUIRE(dn >= 0);
    REQUIRE(abs(dt) <= friction * dn);
    const Rational slip = p.slip + q.slip;  // of one sign on the whole piece
    REQUIRE(p.slip * q.slip >= 0);
    if (slip != 0 && dn > 0) REQUIRE(dt == (slip > 0 ? Rational(-friction) : friction) * dn);
  }
}

}  // namespace

TEST_CASE("impacts with friction obey Coulomb's law at every moment, and each law its own rule") {
  Random random(1712);
  int newton_gains = 0;
  int reversed = 0;
  for (int i = 0; i < 1500; ++i) {
    const auto c = random_contact(random);
    const Rational e = Rational(random.integer(0, 4)) / 4;
    const Rational friction = Rational(random.integer(0, 8)) / 4;
    const auto newton = contact::newton_impact(c, e, friction);
    const auto poisson = contact::poisson_impact(c, e, friction);
    check_path(c, newton, friction);
    check_path(c, poisson, friction);
    REQUIRE(newton.end().normal == -e * c.normal);
    // Up to the largest compression the two are one.
    std::size_t turn = 0;
    while (newton.path[turn].normal != 0 || turn == 0) ++turn;
    REQUIRE(poisson.path[turn].impulse == newton.path[turn].impulse);
    REQUIRE(poisson.end().impulse == (1 + e) * poisson.path[turn].impulse);
    REQUIRE(contact::energy_change(poisson) <= 0);
    newton_gains += contact::energy_change(newton) > 0;
    reversed += newton.end().slip * c.slip < 0;

    const contact::PlanarContact<double> d{oracle::nearest(c.slip), oracle::nearest(c.normal),
                                           oracle::nearest(c.k_tt), oracle::nearest(c.k_tn),
                                           oracle::nearest(c.k_nn)};
    const double ed = oracle::nearest(e);
    const auto stronge = contact::stronge_impact(d, ed, oracle::nearest(friction));
    // The turn of the stored contact; its work is given back by e².
    std::size_t middle = 1;
    while (stronge.path[middle].normal != 0) ++middle;
    const double pressed = -contact::detail::normal_work(stronge, 0, middle);
    const double back = contact::detail::normal_work(stronge, middle, stronge.count - 1);
    // Pieces of opposite sign do not occur after the turn; before it the work can cancel by as much
    // as friction presses the bodies together.
    double size = 0;
    for (std::size_t k = 0; k + 1 < stronge.count; ++k) {
      size += (std::abs(stronge.path[k].normal) + std::abs(stronge.path[k + 1].normal)) *
              stronge.path[k + 1].impulse;
    }
    REQUIRE(std::abs(back - ed * ed * pressed) <= 64 * u * size);
    REQUIRE(contact::energy_change(stronge) <= 64 * u * size * 4);
    // Without coupling or friction all three are one law.
    auto plain = c;
    if (i % 2 == 0) plain.k_tn = 0;
    const Rational none = i % 2 == 0 ? friction : Rational(0);
    const auto one = contact::newton_impact(plain, e, none);
    const auto two = contact::poisson_impact(plain, e, none);
    REQUIRE(one.end().impulse == two.end().impulse);
    REQUIRE(one.end().tangential == two.end().tangential);
    REQUIRE(contact::energy_change(one) <= 0);
  }
  CHECK(newton_gains > 20);
  CHECK(reversed > 20);
}

TEST_CASE("Stronge's law is Newton's and Poisson's where nothing couples") {
  Random random(1713);
  for (int i = 0; i < 500; ++i) {
    const contact::PlanarContact<double> c{random.uniform(-3, 3), -random.uniform(0.1, 3),
                                           random.uniform(0.2, 3), 0, random.uniform(0.2, 3)};
    const double e = random.uniform();
    const double friction = random.uniform(0, 2);
    const auto one = contact::newton_impact(c, e, friction).end();
    const auto other = contact::stronge_impact(c, e, friction).end();
    CHECK(std::abs(one.impulse - other.impulse) <= 32 * u * one.impulse);
    CHECK(std::abs(one.tangential - other.tangential) <=
          64 * u * (friction * one.impulse + std::abs(c.slip) / c.k_tt));
  }
}

TEST_CASE("the rod that gains energy: 1 kg, 2 m, at 45 degrees, its end meeting the floor") {
  // The lower right end of the rod at (−0.6, −1) m/s, ω = −1 rad/s, μ = 1/2, e = 1. In fractions:
  // r = (s, −s) with s² = 1/2 and I = 1/3, so k_tt = k_nn = 5/2 and k_tn = 3/2. The centre moves at
  // v = (s − 3/5, s − 1), and the energy before is ½|v|² + ½ I ω².
  const contact::PlanarContact<Rational> c{Rational(-3) / 5, -1, Rational(5) / 2, Rational(3) / 2,
                                           Rational(5) / 2};
  const double s = std::sqrt(0.5);
  const double before = ((s - 0.6) * (s - 0.6) + (s - 1) * (s - 1)) / 2 + 1.0 / 6;
  const auto factor = [&](const contact::Impact<Rational>& impact) {
    return 1 + oracle::nearest(contact::energy_change(impact)) / before;
  };
  const Rational half = Rational(1) / 2;
  const auto joint = contact::joint_impact<Rational>(c, 1, half);
  REQUIRE(joint.has_value());
  CHECK(joint->end().slip == 0);
  CHECK(contact::energy_change(*joint) == Rational(9) / 80);  // 0.1125 J
  CHECK(std::abs(factor(*joint) - 1.52) < 0.005);
  const auto newton = contact::newton_impact<Rational>(c, 1, half);
  CHECK(newton.end().normal == 1);
  CHECK(std::abs(factor(newton) - 1.25) < 0.005);
  CHECK(std::abs(factor(contact::poisson_impact<Rational>(c, 1, half)) - 0.59) < 0.005);
  const contact::PlanarContact<double> d{-0.6, -1, 2.5, 1.5, 2.5};
  CHECK(std::abs(1 + contact::energy_change(contact::stronge_impact(d, 1.0, 0.5)) / before - 0.74) <
        0.005);
  // The slip stops and, since μ is below k_tn/k_tt = 3/5, turns.
  REQUIRE(newton.count == 4);
  CHECK(newton.path[1].slip == 0);
  CHECK(newton.path[3].slip > 0);
  // Friction after the normal impulse: e is asked to be 1, and comes out otherwise.
  const auto clamped = contact::clamped_impact<Rational>(c, 1, half);
  REQUIRE(clamped.count == 3);
  CHECK(clamped.path[1].normal == 1);
  CHECK(clamped.end().normal == Rational(16) / 25);  // p_t is −0.24 N·s: 1 − 1.5 · 0.24
}

TEST_CASE("the plane contact of a rod is what its two bodies say") {
  const double s = std::sqrt(0.5);
  const double inertia = 1.0 * 2 * 2 / 12;
  const Vector3<double> r(s, -s, 0);
  const Vector3<double> w(0, 0, -1);
  const auto rod =
      contact::rigid_body<double>(1, contact::detail::diagonal<double>(inertia, inertia, inertia),
                                  {0, s, 0}, Vector3<double>(-0.6, -1, 0) - w.cross(r), w);
  const auto floor = contact::immovable<double>({0, 0, 0}, {0, 0, 0}, {0, 0, 0});
  const auto c = contact::planar_contact<double>(rod, floor, {{s, 0, 0}, {0, 1, 0}}, {1, 0, 0});
  CHECK(std::abs(c.slip + 0.6) <= 8 * u);
  CHECK(std::abs(c.normal + 1) <= 8 * u);
  CHECK(std::abs(c.k_tt - 2.5) <= 32 * u);
  CHECK(std::abs(c.k_tn - 1.5) <= 32 * u);
  CHECK(std::abs(c.k_nn - 2.5) <= 32 * u);
  const double before = contact::kinetic_energy(rod);
  const auto impact = contact::newton_impact(c, 1.0, 0.5);
  const auto after = contact::after_impulse<double>(
      rod, {impact.end().tangential, impact.end().impulse, 0}, {s, 0, 0});
  CHECK(std::abs(contact::kinetic_energy(after) - before - contact::energy_change(impact)) <=
        64 * u);
  CHECK(std::abs(contact::kinetic_energy(after) / before - 1.25) < 0.005);
}

TEST_CASE("an impact that does not close, or jams at first, has its answer") {
  const contact::PlanarContact<Rational> apart{1, 1, 1, 0, 1};
  CHECK(contact::newton_impact<Rational>(apart, 1, 1).count == 1);
  CHECK(contact::poisson_impact<Rational>(apart, 1, 1).count == 1);
  CHECK(contact::clamped_impact<Rational>(apart, 1, 1).count == 1);
  CHECK(contact::energy_change(contact::joint_impact<Rational>(apart, 1, 1).value()) == 0);
  // Friction presses the bodies together: k_nn − μ k_tn = 1 − 2·3/4 < 0 while they slip.
  const contact::PlanarContact<Rational> jam{1, -1, 1, Rational(3) / 4, 1};
  const auto impact = contact::poisson_impact<Rational>(jam, 1, 2);
  check_path(jam, impact, 2);
  REQUIRE(impact.count == 4);
  CHECK(impact.path[1].normal < -1);  // closing faster than at the first touch
  CHECK(impact.end().normal > 0);
  CHECK(contact::energy_change(impact) < 0);
}

TEST_CASE("sine and cosine, to a few u and u times the angle") {
  Random random(1714);
  for (int i = 0; i < 2000; ++i) {
    const double x = random.magnitude(-30, 24);
    const auto got = contact::sine_cosine(x);
    const auto by = [&](auto f) {
      return *oracle::nearest_value(
          [&](unsigned bits) { return f(oracle::Interval(oracle::exact(x), bits)); });
    };
    const double room = 4 * u + u * std::abs(x);
    CHECK(std::abs(got.sine - by([](const auto& t) { return sin(t); })) <= room);
    CHECK(std::abs(got.cosine - by([](const auto& t) { return cos(t); })) <= room);
  }
  CHECK(contact::sine_cosine(0.0).sine == 0);
  CHECK(contact::sine_cosine(0.0).cosine == 1);
}

TEST_CASE("the exponential map turns by the angle that it is given") {
  Random random(1715);
  for (int i = 0; i < 500; ++i) {
    const Vector3<double> axis = direction(random);
    const double angle = random.uniform(-3, 3);
    const Matrix3<double> m =
        contact::matrix_of(contact::exponential<double>(Vector3<double>(axis * angle)));
    // The axis stays; a vector across it turns by the angle.
    CHECK((m * axis - axis).norm() <= 64 * u);
    const Vector3<double> across = axis.unitOrthogonal();
    const Vector3<double> right = across * std::cos(angle) + axis.cross(across) * std::sin(angle);
    CHECK((m * across - right).norm() <= 64 * u);
    const Vector3<double> v = direction(random);
    CHECK((contact::cross_matrix<double>(axis) * v - axis.cross(v)).norm() == 0);
  }
  CHECK(contact::exponential<double>(Vector3<double>(0, 0, 0)).w == 1);
  const auto tiny = contact::exponential<double>(Vector3<double>(0, 1e-200, 0));
  CHECK((tiny.w == 1 && tiny.v.y() == 5e-201));
}

TEST_CASE("steps of orientation converge as they should, and a free top keeps its momentum") {
  const Vector3<double> moments(2, 2, 1);
  const auto start = contact::exponential<double>({0.3, 0.5, -0.2});
  const Vector3<double> momentum(3, -1, 4);
  const double t = 1;
  const auto right = contact::matrix_of(contact::free_top<double>(start, momentum, 2, 1, t));
  const auto error = [&](int steps, int method) {
    auto q = start;
    Matrix3<double> m = contact::matrix_of(start);
    const double h = t / steps;
    for (int i = 0; i < steps; ++i) {
      const auto spin = contact::free_spin<double>(
          momentum, moments, method == 0 ? contact::orthonormalised(m) : contact::matrix_of(q));
      if (method == 0) m = contact::matrix_step<double>(m, spin, h);
      if (method == 1) q = contact::quaternion_step<double>(q, spin, h);
      if (method == 2) q = contact::exponential_step<double>(q, spin, h);
      if (method == 3) q = contact::midpoint_step<double>(q, momentum, moments, h);
    }
    return ((method == 0 ? m : contact::matrix_of(q)) - right).norm();
  };
  // Halving h halves an error of first order and quarters one of second order; the next term of the
  // series is what is left, a few h.
  for (const int method : {0, 1, 2}) {
    const double ratio = error(1000, method) / error(2000, method);
    CHECK(std::abs(ratio - 2) < 0.05);
  }
  CHECK(std::abs(error(1000, 3) / error(2000, 3) - 4) < 0.05);
  CHECK(error(2000, 3) < 1e-5);

  // The closed form solves the equation: a difference quotient of R is ω × R.
  const double h = 0x1p-16;
  const auto before = contact::matrix_of(contact::free_top<double>(start, momentum, 2, 1, t - h));
  const auto after = contact::matrix_of(contact::free_top<double>(start, momentum, 2, 1, t + h));
  const Vector3<double> spin = contact::free_spin<double>(momentum, moments, right);
  const Matrix3<double> slope = (after - before) / (2 * h);
  // h²/6 of the third derivative, at most (|L|/I)³ = 132 each, and u/h of rounding.
  CHECK((slope - contact::cross_matrix<double>(spin) * right).norm() < 1e-7);
}

TEST_CASE("Euler's matrix grows, and the quaternion lags, as their comments say") {
  const double w = 3;
  const double h = 1.0 / 64;
  Matrix3<double> m = Matrix3<double>::Identity();
  contact::Rotor<double> q;
  for (int i = 0; i < 64; ++i) {
    m = contact::matrix_step<double>(m, {0, 0, w}, h);
    q = contact::quaternion_step<double>(q, {0, 0, w}, h);
  }
  const double growth = std::pow(std::sqrt(1 + w * w * h * h), 64);
  CHECK(std::abs(m.col(0).norm() - growth) < 1e-12);
  const double turned = 2 * std::atan2(q.v.z(), q.w);
  CHECK(std::abs(turned - 64 * 2 * std::atan(w * h / 2)) < 1e-12);
  CHECK(std::abs((w - turned) - 64 * w * w * w * h * h * h / 12) < 1e-6);
}

TEST_CASE("constructions refuse bad input, naming it") {
  const Vector3<double> zero(0, 0, 0);
  const Matrix3<double> one = Matrix3<double>::Identity();
  const double inf = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {0.0, -1.0, inf, nan, 5e-324}) {
    CHECK(contains(refusal([&] { contact::rigid_body<double>(bad, one, zero, zero, zero); }),
                   "mass = "));
  }
  CHECK(contains(refusal([&] { contact::rigid_body<double>(1, -one, zero, zero, zero); }),
                 "positive definite"));
  Matrix3<double> skew = one;
  skew(0, 1) = 0.1;
  CHECK(contains(refusal([&] { contact::rigid_body<double>(1, skew, zero, zero, zero); }),
                 "symmetric"));
  skew(0, 1) = nan;
  CHECK(
      contains(refusal([&] { contact::rigid_body<double>(1, skew, zero, zero, zero); }), "finite"));
  CHECK(contains(refusal([&] {
                   contact::rigid_body<double>(1, one, zero, {nan, 0, 0}, zero);
                 }),
                 "velocity"));
  CHECK(contains(refusal([&] { contact::immovable<double>(zero, zero, {0, inf, 0}); }), "spin"));
  CHECK(contains(refusal([&] {
                   contact::rigid_body_from_axes<double>(1, {1, 0, 1}, one, zero, zero, zero);
                 }),
                 "moments = 0"));
  CHECK(contains(refusal([&] {
                   contact::rigid_body_from_axes<double>(1, {1, 1, 1}, Matrix3<double>(one * nan),
                                                         zero, zero, zero);
                 }),
                 "rotation"));
  CHECK(contains(refusal([] { contact::sphere_inertia<double>(1, 0); }), "radius = 0"));
  CHECK(contains(refusal([] { contact::box_inertia<double>(1, {1, -2, 1}); }), "size = -2"));
  CHECK(contains(refusal([] { contact::cylinder_inertia<double>(1, 1, 0); }), "height = 0"));
  CHECK(contains(refusal([] { contact::capsule_inertia<double>(1, 1, -1); }), "height = -1"));
  CHECK(contains(refusal([&] { contact::mesh_mass<double>(0, {zero}, {}); }), "density"));
  CHECK(contains(refusal([&] { contact::mesh_mass<double>(1, {{inf, 0, 0}}, {}); }), "vertices"));
  CHECK(contains(refusal([&] {
                   contact::mesh_mass<double>(1, {zero}, {{0, 0, 1}});
                 }),
                 "triangles = 1"));
}
