// rigid_body.hpp and rigid_impulse.hpp: what a collision without friction conserves, in exact
// fractions and to rounding.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/inertia.hpp>
#include <contact/quaternion.hpp>
#include <contact/rigid_body.hpp>
#include <contact/rigid_impulse.hpp>
#include <vector>

#include "reference.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

using contact::Closing;
using contact::ContactPoint;
using contact::Matrix3;
using contact::RigidBody;
using contact::Vector3;
using generators::Random;
using oracle::Rational;
using oracle::Vector;
using reference::direction;
using reference::Matrix;
using reference::positive;
using reference::rational_rotation;
using reference::u;
using reference::vector;

namespace {

using Body = RigidBody<double>;
using Exactly = RigidBody<Rational>;

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
  return {oracle::exact(b.mass),
          exact_matrix(b.inertia),
          oracle::exact(b.inverse_mass),
          exact_matrix(b.inverse_inertia),
          oracle::exact(b.position),
          oracle::exact(b.velocity),
          oracle::exact(b.angular_velocity)};
}

Rational energy(const Body& a, const Body& b) {
  return contact::kinetic_energy(exactly(a)) + contact::kinetic_energy(exactly(b));
}

}  // namespace

TEST_CASE("a frictionless collision conserves what it must, in exact fractions") {
  Random random(1706);
  int met = 0;
  int grounded = 0;
  for (int i = 0; i < 300; ++i) {
    const Exactly a = rational_body(random);
    Exactly b = rational_body(random);
    const bool against_moving = i % 5 == 0;
    const bool against_ground = i % 5 == 1;
    if (against_moving)
      b = contact::immovable<Rational>(b.position, b.velocity, b.angular_velocity);
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
    // An immovable body that moves does work; the ground does none.
    if (!against_moving) {
      grounded += against_ground;
      CHECK(k1 <= k0);
      // The loss is ½ (1 − e²) v_n² / k, with k the inverse effective mass along n.
      const Rational k =
          contact::inverse_effective_mass<Rational>(a, b, at.point, at.normal, at.normal);
      CHECK(k0 - k1 == (1 - e * e) * before * before / k / 2);
    }
  }
  CHECK(met > 100);
  CHECK(grounded > 20);
}

TEST_CASE("the inverse effective mass is the effect of one unit of impulse") {
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
    CHECK(contact::inverse_effective_mass<Rational>(a, b, p, out, in) == out.dot(change));
    CHECK(contact::inverse_effective_mass<Rational>(a, b, p, in, out) ==
          contact::inverse_effective_mass<Rational>(a, b, p, out, in));
  }
}

TEST_CASE("a collision through the centres of mass is one without rotation") {
  Random random(1708);
  for (int i = 0; i < 100; ++i) {
    Exactly a = rational_body(random);
    Exactly b = rational_body(random);
    const Vector n = rational_direction(random);
    const ContactPoint<Rational> at{b.position + n * positive(random), n};
    a.position = at.point + n * positive(random);
    const auto [a2, b2, impulse] = contact::collide<Rational>(a, b, at, Rational(1) / 2);
    CHECK(a2.angular_velocity == a.angular_velocity);
    CHECK(b2.angular_velocity == b.angular_velocity);
    CHECK(impulse ==
          Vector(n * contact::impulse_without_rotation<Rational>(a, b, at, Rational(1) / 2)));
  }
}

TEST_CASE("in floating point a collision conserves momentum to rounding, and meets e") {
  Random random(1709);
  int met = 0;
  int grounded = 0;
  for (int i = 0; i < 1500; ++i) {
    const Body a = body(random, std::ldexp(random.uniform(1, 2), random.integer(-40, 40)));
    Body b = body(random, std::ldexp(random.uniform(1, 2), random.integer(-40, 40)));
    if (i % 7 == 0) b = contact::immovable<double>(b.position, b.velocity, b.angular_velocity);
    const bool ground = i % 7 == 1;
    if (ground) {
      b = contact::immovable<double>(b.position, Vector3<double>::Zero(), Vector3<double>::Zero());
    }
    const ContactPoint<double> at{{random.uniform(-2, 2), random.uniform(-2, 2), 0},
                                  direction(random)};
    const double e = random.uniform();
    const auto [a2, b2, impulse] = contact::collide<double>(a, b, at, e);
    if (contact::closing_case(a, b, at) != Closing::approaching) {
      CHECK((a2.velocity == a.velocity && b2.angular_velocity == b.angular_velocity));
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
      const Vector angular_impulse = contact::angular_momentum(exactly(a2), oracle::exact(o)) +
                                     contact::angular_momentum(exactly(b2), oracle::exact(o)) -
                                     contact::angular_momentum(exactly(a), oracle::exact(o)) -
                                     contact::angular_momentum(exactly(b), oracle::exact(o));
      // Σ|r||p|, the rotations' Iω, and the angular impulses I I⁻¹ (r × J). The stored inverse is
      // off by 20 u of I⁻¹ (two products of three), so by 20 u times I's ratio of at most 20 of r ×
      // J.
      const auto turning = [](const Body& x) {
        return x.position.norm() * x.mass * x.velocity.norm() +
               x.inertia.norm() * x.angular_velocity.norm();
      };
      const double arms = (at.point - a.position).norm() + (at.point - b.position).norm();
      const double angular =
          turning(a) + turning(a2) + turning(b) + turning(b2) + 20 * arms * impulse.norm();
      for (int k = 0; k < 3; ++k) CHECK(abs(angular_impulse(k)) <= oracle::exact(40 * u * angular));
    }
    if (b.mass > 0 || ground) {
      grounded += ground;
      CHECK(energy(a2, b2) <= energy(a, b) * (1 + oracle::exact(2000 * u)));
    }
    const double fast = contact::normal_velocity(a2, b2, at);
    const double right = -e * contact::normal_velocity(a, b, at);
    const auto speed = [&](const Body& x) {
      return x.velocity.norm() + x.angular_velocity.norm() * (at.point - x.position).norm();
    };
    CHECK(std::abs(fast - right) <= 200 * u * (speed(a) + speed(b) + speed(a2) + speed(b2)));
  }
  CHECK(met > 500);
  CHECK(grounded > 50);
}

TEST_CASE("bodies do not close after a collision, however slow they were") {
  // Velocities and angular velocities are of the order of 10; the closing velocity is one ulp of
  // one of them, a few ulps of all, or the remainder of a cancellation.
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
    // The impulse is raised until v_n is not below 0, in doubling steps: by at most three times the
    // rounding of the velocities, as in the test above.
    const auto speed = [&](const Body& x) {
      return x.velocity.norm() + x.angular_velocity.norm() * (at.point - x.position).norm();
    };
    const Rational right =
        -oracle::exact(e) * contact::normal_velocity(exactly(a), exactly(b), exact_at);
    CHECK(abs(after - right) <=
          oracle::exact(600 * u * (speed(a) + speed(b) + speed(a2) + speed(b2))));
    // One impulse for both, whatever it is: momentum is conserved, and no energy gained.
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

TEST_CASE("a collision near overflow stays finite, and one near underflow separates") {
  for (const double speed : {0x1p1022, 0x1p-1070}) {
    for (const double e : {0.0, 0.5}) {
      Random random(1718);
      for (int i = 0; i < 50; ++i) {
        Body a = body(random, 1);
        Body b = body(random, 1);
        a.velocity *= speed / 8;
        b.velocity *= speed / 8;
        a.angular_velocity *= speed / 64;
        b.angular_velocity *= speed / 64;
        const ContactPoint<double> at{{random.uniform(-1, 1), random.uniform(-1, 1), 0},
                                      Vector3<double>::UnitZ()};
        const auto [a2, b2, impulse] = contact::collide<double>(a, b, at, e);
        for (const Body& x : {a2, b2})
          CHECK((x.velocity.allFinite() && x.angular_velocity.allFinite()));
        if (!(impulse.norm() > 0) && speed < 1) continue;  // below the smallest number
        if (speed < 1) CHECK(contact::closing_case(a2, b2, at) != Closing::approaching);
      }
    }
  }
}

TEST_CASE("the closing case is exact for the numbers as stored") {
  Random random(1710);
  int rescued = 0;
  for (int i = 0; i < 3000; ++i) {
    Body a = body(random, 1);
    Body b = body(random, 1);
    ContactPoint<double> at{{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)},
                            direction(random)};
    const int scale = random.integer(-3, 3) * 150;
    if (i % 2 == 0) {
      // Chosen so that v_n is about 0: far below what plain arithmetic can resolve.
      const Vector3<double> relative =
          contact::velocity_at(a, at.point) - contact::velocity_at(b, at.point);
      b.velocity += at.normal * at.normal.dot(relative);
    }
    for (Body* x : {&a, &b}) {
      for (int k = 0; k < 3; ++k) {
        x->velocity(k) = std::ldexp(x->velocity(k), scale);
        x->angular_velocity(k) = std::ldexp(x->angular_velocity(k), scale);
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
  CHECK(rescued > 100);  // wrong in plain arithmetic
}

TEST_CASE("a thin rod is a box whose other edges have length 0") {
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

TEST_CASE("a hit at the centre of percussion leaves the other end at rest") {
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
