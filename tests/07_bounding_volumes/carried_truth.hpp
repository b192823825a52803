/// @file
/// What the tests of carried, moving and meeting volumes compare with: frames, points and images as
/// fractions, and whether such a point is in a volume.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <contact/aabb.hpp>
#include <contact/capsule.hpp>
#include <contact/frame.hpp>
#include <contact/oriented_box.hpp>
#include <contact/ray_kdop.hpp>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <support/generators.hpp>
#include <support/oracle.hpp>
#include <support/rounding.hpp>

namespace carried_truth {

using contact::Matrix3;
using contact::Vector3;
using generators::Random;
using oracle::Rational;
using oracle::Vector;
using ExactMatrix = Matrix3<Rational>;

// ---------------------------------------------------------------- rotations

/// A quaternion of whole numbers: its rotation is a matrix of fractions.
struct WholeQuaternion {
  Rational w{1}, x{0}, y{0}, z{0};
};
/// First b's rotation, then a's.
inline WholeQuaternion operator*(const WholeQuaternion& a, const WholeQuaternion& b) {
  return {
      a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
      a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}
inline ExactMatrix rotation_of(const WholeQuaternion& q) {
  const Rational n = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
  const auto at = [&n](const Rational& x) { return Rational(2 * x / n); };
  ExactMatrix m;
  m << 1 - at(q.y * q.y + q.z * q.z), at(q.x * q.y - q.w * q.z), at(q.x * q.z + q.w * q.y),
      at(q.x * q.y + q.w * q.z), 1 - at(q.x * q.x + q.z * q.z), at(q.y * q.z - q.w * q.x),
      at(q.x * q.z - q.w * q.y), at(q.y * q.z + q.w * q.x), 1 - at(q.x * q.x + q.y * q.y);
  return m;
}
inline WholeQuaternion any_quaternion(Random& random, int size) {
  const std::array<int, 4> n{random.integer(-size, size), random.integer(-size, size),
                             random.integer(-size, size), random.integer(1, size)};
  return {n[0], n[1], n[2], n[3]};
}

/// Each entry rounded once.
template <std::floating_point S>
Matrix3<S> stored(const ExactMatrix& m) {
  Matrix3<S> result;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) result(i, j) = rounding::nearest<S>(m(i, j));
  }
  return result;
}
template <std::floating_point S>
ExactMatrix exact(const Matrix3<S>& m) {
  ExactMatrix result;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) result(i, j) = oracle::exact(m(i, j));
  }
  return result;
}
/// Rounded rotations with origins of all magnitudes from 2^-10 to 2^30.
template <std::floating_point S>
contact::CoordinateFrame<S> any_frame(Random& random) {
  const ExactMatrix axes = rotation_of(any_quaternion(random, 1000));
  const Vector3<double> origin{random.magnitude(-10, 30), random.magnitude(-10, 30),
                               random.magnitude(-10, 30)};
  return {generators::rounded<S>(origin), stored<S>(axes)};
}

// ---------------------------------------------------------------- points

template <std::floating_point S>
Vector image(const contact::CoordinateFrame<S>& frame, const Vector& p) {
  return oracle::exact(frame.origin) + Vector(exact(frame.axes) * p);
}
/// A vector of fractions whose length is exactly 1, close to a direction: the direction projected
/// from (0, 0, ∓1) to the plane z = 0, rounded there, and back.
inline Vector unit_near(const Vector3<double>& direction) {
  const Vector3<double> n = direction.stableNormalized();
  const double sign = n.z() < 0 ? -1 : 1;
  const double below = 1 + std::abs(n.z());
  const Rational x = oracle::exact(n.x() / below), y = oracle::exact(n.y() / below);
  const Rational s = x * x + y * y;
  return {2 * x / (1 + s), 2 * y / (1 + s), Rational(int(sign)) * (1 - s) / (1 + s)};
}
inline Vector3<double> any_direction(Random& random) {
  return Vector3<double>{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0.1, 1)};
}
/// The eight corners of a box, exactly as stored.
template <std::floating_point S>
std::array<Vector, 8> corners(const contact::OrientedBox<S>& box) {
  std::array<Vector, 8> points;
  for (std::size_t k = 0; k < 8; ++k) {
    points[k] = oracle::exact(box.centre);
    for (int i = 0; i < 3; ++i) {
      const Vector axis = exact(box.axes).col(i);
      const Rational half = oracle::exact(box.half_lengths[i]);
      points[k] += ((k >> i) & 1) != 0 ? Vector(half * axis) : Vector(-half * axis);
    }
  }
  return points;
}
template <std::floating_point S>
std::array<Vector, 8> corners(const contact::Aabb<S>& box) {
  std::array<Vector, 8> points;
  for (std::size_t k = 0; k < 8; ++k) {
    for (int i = 0; i < 3; ++i) {
      points[k][i] = oracle::exact(((k >> i) & 1) != 0 ? box.high[i] : box.low[i]);
    }
  }
  return points;
}

// ---------------------------------------------------------------- inside

template <std::floating_point S>
bool inside(const contact::Sphere<S>& sphere, const Vector& p) {
  const Vector d = p - oracle::exact(sphere.centre);
  const Rational r = oracle::exact(sphere.radius);
  return r >= 0 && d.dot(d) <= r * r;
}
template <std::floating_point S>
bool inside(const contact::Aabb<S>& box, const Vector& p) {
  for (int k = 0; k < 3; ++k) {
    if (p[k] < oracle::exact(box.low[k]) || oracle::exact(box.high[k]) < p[k]) return false;
  }
  return true;
}
/// Cramer's rule: |det(p, b, c)| ≤ h |det(a, b, c)|, and so on.
template <std::floating_point S>
bool inside(const contact::OrientedBox<S>& box, const Vector& p) {
  const ExactMatrix axes = exact(box.axes);
  const Vector d = p - oracle::exact(box.centre);
  const Rational all = abs(axes.col(0).dot(axes.col(1).cross(axes.col(2))));
  for (int i = 0; i < 3; ++i) {
    const Rational one = abs(d.dot(axes.col((i + 1) % 3).cross(axes.col((i + 2) % 3))));
    if (one > oracle::exact(box.half_lengths[i]) * all) return false;
  }
  return true;
}
template <std::floating_point S>
bool inside(const contact::Kdop<S>& dop, const Vector& p) {
  for (std::size_t k = 0; k < dop.normals.size(); ++k) {
    const Rational at = oracle::exact(dop.normals[k]).dot(p);
    if (at < oracle::exact(dop.low[k]) || oracle::exact(dop.high[k]) < at) return false;
  }
  return true;
}
template <std::floating_point S>
bool inside(const contact::Capsule<S>& capsule, const Vector& p) {
  const Vector start = oracle::exact(capsule.core.start);
  const Vector along = oracle::exact(capsule.core.end) - start;
  const Rational length = along.dot(along);
  Rational t = length == 0 ? Rational(0) : Rational((p - start).dot(along) / length);
  t = std::min(std::max(t, Rational(0)), Rational(1));
  const Vector d = p - start - t * along;
  const Rational r = oracle::exact(capsule.radius);
  return d.dot(d) <= r * r;
}

}  // namespace carried_truth
