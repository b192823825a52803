// quaternion.hpp, sine_cosine.hpp and pose.hpp.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/pose.hpp>
#include <contact/quaternion.hpp>
#include <contact/sine_cosine.hpp>
#include <contact/tolerance.hpp>
#include <limits>
#include <numbers>

#include "support/generators.hpp"
#include "support/oracle.hpp"
#include "support/refusal.hpp"

namespace quaternion_test {

using contact::Matrix3;
using contact::Quaternion;
using contact::Vector3;
using generators::Random;
using support::contains;
using support::refusal;
constexpr double u = contact::tolerance::unit_roundoff<double>;

Vector3<double> any_point(Random& random, double size) {
  const double x = random.uniform(-size, size);
  const double y = random.uniform(-size, size);
  return {x, y, random.uniform(-size, size)};
}

/// A unit vector.
Vector3<double> direction(Random& random) {
  for (;;) {
    const Vector3<double> v = any_point(random, 1);
    if (v.norm() > 0.1 && v.norm() <= 1) return v.normalized();
  }
}

/// The distance of two quaternions as rotations.
double distance(const Quaternion<double>& p, const Quaternion<double>& q) {
  return std::min(std::hypot(p.w - q.w, (p.v - q.v).norm()),
                  std::hypot(p.w + q.w, (p.v + q.v).norm()));
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

TEST_CASE("the exponential map rotates by the given angle") {
  Random random(1715);
  for (int i = 0; i < 500; ++i) {
    const Vector3<double> axis = direction(random);
    const double angle = random.uniform(-3, 3);
    const Matrix3<double> m =
        contact::matrix_of(contact::exponential<double>(Vector3<double>(axis * angle)));
    // The axis is fixed; a vector perpendicular to it rotates by the angle.
    CHECK((m * axis - axis).norm() <= 64 * u);
    const Vector3<double> transverse = axis.unitOrthogonal();
    const Vector3<double> right =
        transverse * std::cos(angle) + axis.cross(transverse) * std::sin(angle);
    CHECK((m * transverse - right).norm() <= 64 * u);
  }
  CHECK(contact::exponential<double>(Vector3<double>(0, 0, 0)).w == 1);
  const auto tiny = contact::exponential<double>(Vector3<double>(0, 1e-200, 0));
  CHECK((tiny.w == 1 && tiny.v.y() == 5e-201));
}

TEST_CASE("the exponential map of numbers that are not finite is NaN, not a rotation") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, -infinity}) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const double other : {0.0, 1.0}) {
        Vector3<double> a = Vector3<double>::Constant(other);
        a(axis) = bad;
        const auto q = contact::exponential<double>(a);
        CAPTURE(bad, axis, other);
        CHECK(std::isnan(q.w));
        for (int k = 0; k < 3; ++k) CHECK(std::isnan(q.v(k)));
      }
    }
  }
}

TEST_CASE("an axis and an angle give the rotation that the exponential map gives") {
  Random random(1716);
  for (int i = 0; i < 500; ++i) {
    const Vector3<double> axis = direction(random);
    const double angle = random.uniform(-7, 7);
    const double size = std::ldexp(1.0, random.integer(-1000, 1000));
    const auto q = contact::from_axis_angle<double>(axis * size, angle);
    CHECK(distance(q, contact::exponential<double>(axis * angle)) <= 16 * u);
    CHECK(std::abs(q.w * q.w + q.v.dot(q.v) - 1) <= 16 * u);
  }
  // Counter-clockwise: a quarter turn about z takes x to y.
  const auto quarter = contact::from_axis_angle<double>({0, 0, 3}, std::numbers::pi / 2);
  const Vector3<double> y = contact::matrix_of(quarter) * Vector3<double>::UnitX();
  CHECK((y - Vector3<double>::UnitY()).norm() <= 4 * u);
  CHECK(contact::from_axis_half_angle<double>({0, 2, 0}, {1, 0}).v == Vector3<double>::UnitY());
  CHECK(contact::from_axis_angle<double>({1, 2, 3}, 0).w == 1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto make = [](const Vector3<double>& axis, double angle) {
    return refusal([&] { contact::from_axis_angle<double>(axis, angle); });
  };
  CHECK(contains(make({0, 0, 0}, 1), "axis = (0, 0, 0)"));
  CHECK(contains(make({0, nan, 0}, 1), "axis = (0, nan, 0)"));
  CHECK(contains(make({0, 1, 0}, nan), "angle = nan"));
}

TEST_CASE("a quaternion, its matrix and back") {
  Random random(1717);
  for (int i = 0; i < 4000; ++i) {
    // Also coordinates that are 0 or tiny, half turns and the identity.
    const auto part = [&] {
      const int kind = random.integer(0, 3);
      return kind == 0 ? 0.0 : (kind == 1 ? random.magnitude(-60, -20) : random.uniform(-1, 1));
    };
    Quaternion<double> q;
    q.w = part();
    for (int k = 0; k < 3; ++k) q.v(k) = part();
    if (q.w * q.w + q.v.dot(q.v) < 1e-4) q.v(i % 3) = 1;
    q = contact::normalised(q);
    const Matrix3<double> m = contact::matrix_of(q);
    CHECK((m.transpose() * m - Matrix3<double>::Identity()).cwiseAbs().maxCoeff() <= 32 * u);
    const auto back = contact::quaternion_of(m);
    CHECK(back.w >= 0);
    CHECK(distance(back, q) <= 8 * u);
    CHECK((contact::matrix_of(back) - m).cwiseAbs().maxCoeff() <= 16 * u);
    // The product is the product of the matrices.
    const auto other = contact::exponential<double>(any_point(random, 2));
    CHECK((contact::matrix_of(q * other) - m * contact::matrix_of(other)).cwiseAbs().maxCoeff() <=
          32 * u);
    const contact::Pose<double> pose{any_point(random, 9), q};
    const auto frame = contact::frame_of(pose);
    CHECK((frame.origin == pose.position && frame.axes == m));
    const auto again = contact::pose_of(frame);
    CHECK((again.position == pose.position && distance(again.orientation, q) <= 8 * u));
  }
  CHECK(contact::quaternion_of<float>(Matrix3<float>::Identity()).w == 1);
  const Matrix3<double> half_turn = Vector3<double>(-1, 1, -1).asDiagonal();
  CHECK(contact::quaternion_of(half_turn).v == Vector3<double>::UnitY());
}

}  // namespace quaternion_test
