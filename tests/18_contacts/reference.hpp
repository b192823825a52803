/// @file
/// Random bodies and contacts, stored and in fractions, and the conditions of a solution.
#pragma once

#include <contact/contact_lcp.hpp>
#include <vector>

#include "09_separating_planes/random_poses.hpp"
#include "09_separating_planes/shape_oracle.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

namespace reference {

using contact::BodyContact;
using contact::Matrix3;
using contact::OrientedBox;
using contact::RigidBody;
using contact::Vector3;
using generators::Random;
using oracle::Rational;
using oracle::Vector;
using random_poses::any_point;
using random_poses::turn;

using V = Vector3<double>;
using Box = OrientedBox<double>;
using Body = RigidBody<double>;
using Exactly = RigidBody<Rational>;
inline constexpr double u = 0x1p-53;

inline Box box(Random& random) {
  const V place = any_point(random, 1.5);
  const Matrix3<double> axes = turn(random);
  const double x = random.uniform(0.2, 2);
  const double y = random.uniform(0.2, 2);
  return {place, axes, V(x, y, random.uniform(0.2, 2))};
}

inline Rational fraction(Random& random) {
  return Rational(random.integer(-9, 9)) / random.integer(1, 4);
}

inline Vector vector(Random& random) {
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

inline Problem<Rational> problem(Random& random, int count, int contacts) {
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

inline double down(const Rational& x) { return oracle::nearest(x); }
inline V down(const Vector& v) { return oracle::nearest(v); }
inline Matrix3<double> down(const Matrix3<Rational>& m) { return shape_oracle::rounded(m); }

inline Problem<double> down(const Problem<Rational>& p) {
  Problem<double> d;
  for (const Exactly& b : p.bodies) {
    d.bodies.push_back({down(b.mass), down(b.inertia), down(b.inverse_mass),
                        down(b.inverse_inertia), down(b.position), down(b.velocity),
                        down(b.angular_velocity)});
  }
  for (const auto& c : p.contacts) {
    d.contacts.push_back(
        {c.a, c.b, down(c.point), down(c.normal), down(c.friction), down(c.min_velocity)});
  }
  return d;
}

/// The numbers that are stored, as fractions.
inline Problem<Rational> exactly(const Problem<double>& d) {
  Problem<Rational> stored;
  for (const Body& b : d.bodies) {
    stored.bodies.push_back({oracle::exact(b.mass), shape_oracle::exact(b.inertia),
                             oracle::exact(b.inverse_mass), shape_oracle::exact(b.inverse_inertia),
                             oracle::exact(b.position), oracle::exact(b.velocity),
                             oracle::exact(b.angular_velocity)});
  }
  for (const auto& c : d.contacts) {
    stored.contacts.push_back({c.a, c.b, oracle::exact(c.point), oracle::exact(c.normal),
                               oracle::exact(c.friction), oracle::exact(c.min_velocity)});
  }
  return stored;
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

}  // namespace reference
