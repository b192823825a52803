// rotation.hpp: sine and cosine, the exponential map, and steps of orientation.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/inertia.hpp>
#include <contact/rotation.hpp>

#include "reference.hpp"
#include "support/generators.hpp"
#include "support/oracle.hpp"

using contact::Matrix3;
using contact::Vector3;
using generators::Random;
using reference::direction;
using reference::u;

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
    const Vector3<double> v = direction(random);
    CHECK((contact::cross_matrix<double>(axis) * v - axis.cross(v)).norm() == 0);
  }
  CHECK(contact::exponential<double>(Vector3<double>(0, 0, 0)).w == 1);
  const auto tiny = contact::exponential<double>(Vector3<double>(0, 1e-200, 0));
  CHECK((tiny.w == 1 && tiny.v.y() == 5e-201));
}

TEST_CASE(
    "steps of orientation converge at their order, and a free top conserves its angular momentum") {
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
      const auto angular_velocity = contact::free_angular_velocity<double>(
          momentum, moments, method == 0 ? contact::orthonormalised(m) : contact::matrix_of(q));
      if (method == 0) m = contact::matrix_step<double>(m, angular_velocity, h);
      if (method == 1) q = contact::quaternion_step<double>(q, angular_velocity, h);
      if (method == 2) q = contact::exponential_step<double>(q, angular_velocity, h);
      if (method == 3) q = contact::midpoint_step<double>(q, momentum, moments, h);
    }
    return ((method == 0 ? m : contact::matrix_of(q)) - right).norm();
  };
  // Halving h halves an error of first order and quarters one of second order; the next term of the
  // series remains, a few h.
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
  const Vector3<double> angular_velocity =
      contact::free_angular_velocity<double>(momentum, moments, right);
  const Matrix3<double> slope = (after - before) / (2 * h);
  // h²/6 of the third derivative, at most (|L|/I)³ = 132 each, and u/h of rounding.
  CHECK((slope - contact::cross_matrix<double>(angular_velocity) * right).norm() < 1e-7);
}

TEST_CASE("Euler's matrix grows and the quaternion lags as documented") {
  const double w = 3;
  const double h = 1.0 / 64;
  Matrix3<double> m = Matrix3<double>::Identity();
  contact::Quaternion<double> q;
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
