// rotation.hpp: steps of orientation.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <contact/inertia.hpp>
#include <contact/quaternion.hpp>
#include <contact/rotation.hpp>

#include "reference.hpp"
#include "support/generators.hpp"

using contact::Matrix3;
using contact::Vector3;
using generators::Random;
using reference::direction;
using reference::u;

TEST_CASE("the cross matrix of a vector") {
  Random random(1715);
  for (int i = 0; i < 500; ++i) {
    const Vector3<double> axis = direction(random);
    const Vector3<double> v = direction(random);
    CHECK((contact::cross_matrix<double>(axis) * v - axis.cross(v)).norm() == 0);
  }
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
