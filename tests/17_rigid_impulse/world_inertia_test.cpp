// Right answers are the formulas without rounding, rounded once. Every test asks for at least two
// different answers, so that no constant passes one.
#include "world_inertia.hpp"

#include <support/exercise.hpp>
#include <support/generators.hpp>

#include <contact/exact.hpp>

namespace {

using namespace contact::testing;
using contact::Exact;
using Matrix = Eigen::Matrix3d;
using Vector = Eigen::Vector3d;

Matrix diagonal(double x, double y, double z) { return Vector(x, y, z).asDiagonal(); }

void check_box(double mass, const Vector& size) {
  Matrix right = Matrix::Zero();
  for (int k = 0; k < 3; ++k) {
    const Exact y(size((k + 1) % 3));
    const Exact z(size((k + 2) % 3));
    right(k, k) = quotient<double>(Exact(mass) * (y * y + z * z), Exact(12.0));
  }
  ask("What is the tensor of the box about its centre of mass?")
      .given("mass", mass)
      .given("size", size)
      .suspect("half-lengths-for-lengths", [&]() -> Matrix { return 4 * right; })
      .suspect("length-along-the-axis",
               [&]() -> Matrix {
                 return diagonal(size.x() * size.x(), size.y() * size.y(), size.z() * size.z()) *
                        (mass / 12);
               })
      .answer([&] { return exercise::box_inertia(mass, size); })
      // Two squares, a sum, a product and a quotient: 5 u, and 1 u of the oracle's. Doubled.
      .close_to(right, within(Matrix(12 * 0x1p-53 * right)));
}

void check_point(const Matrix& central, double mass, const Vector& d) {
  Matrix right;
  Matrix bound;
  const double square = d.squaredNorm();
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      Exact here = Exact(0.0) - Exact(d(i)) * Exact(d(k));
      if (i == k) {
        for (int l = 0; l < 3; ++l) here += Exact(d(l)) * Exact(d(l));
      }
      right(i, k) = rounded<double>(Exact(central(i, k)) + Exact(mass) * here);
      // Squares, two sums, a difference, a product and a sum: 6 u of the terms, and 1 u. Doubled.
      bound(i, k) =
          14 * 0x1p-53 * (std::abs(central(i, k)) + mass * (square + std::abs(d(i) * d(k))));
    }
  }
  ask("What is the tensor about the point?")
      .given("central", central)
      .given("mass", mass)
      .given("offset", d)
      .suspect("axis-part-not-taken-off",
               [&]() -> Matrix { return central + mass * square * Matrix::Identity(); })
      .suspect("axis-part-not-taken-off",
               [&]() -> Matrix { return central + mass * d * d.transpose(); })
      .suspect("parallel-axis-subtracted", [&]() -> Matrix { return 2 * central - right; })
      .answer([&] { return exercise::about_point(central, mass, d); })
      .close_to(right, within(bound));
}

void check_world(const Matrix& inertia, const Matrix& rotation) {
  Matrix right;
  Matrix bound;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      Exact sum;
      double size = 0;
      for (int l = 0; l < 3; ++l) {
        for (int m = 0; m < 3; ++m) {
          sum += Exact(rotation(i, l)) * Exact(inertia(l, m)) * Exact(rotation(k, m));
          size += std::abs(rotation(i, l) * inertia(l, m) * rotation(k, m));
        }
      }
      right(i, k) = rounded<double>(sum);
      bound(i, k) =
          14 * 0x1p-53 * size;  // two products and four sums, 1 u of the oracle's; doubled
    }
  }
  ask("What is the tensor in the axes of the world?")
      .given("inertia", inertia)
      .given("rotation", rotation)
      .suspect("tensor-in-body-frame", [&]() -> Matrix { return inertia; })
      .suspect("rotated-the-other-way",
               [&]() -> Matrix { return rotation.transpose() * inertia * rotation; })
      .suspect("tensor-turned-like-a-vector", [&]() -> Matrix { return rotation * inertia; })
      .answer([&] { return exercise::in_world(inertia, rotation); })
      .close_to(right, within(bound));
}

/// The rotation of the quaternion w + v, which need not have length 1.
Matrix rotation_of(double w, const Vector& v) {
  return Eigen::Quaterniond(w, v.x(), v.y(), v.z()).normalized().toRotationMatrix();
}

}  // namespace

TEST_CASE("a box has a larger moment perpendicular to its length") {
  check_box(12, {1, 2, 3});
  check_box(3, {8, 1, 1});
  check_box(6, {2, 2, 2});
}

TEST_CASE("the tensor about another point follows the parallel-axis theorem") {
  check_point(diagonal(5, 4, 3), 2, {0, 0, 3});
  check_point(diagonal(1, 1, 1), 4, {1, 2, 0});
  check_point(diagonal(5, 4, 3), 1, {1, -2, 3});
}

TEST_CASE("a quarter turn exchanges two moments") {
  Matrix about_z;
  about_z << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  check_world(diagonal(1, 2, 3), about_z);
  Matrix about_x;
  about_x << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  check_world(diagonal(1, 2, 3), about_x);
}

TEST_CASE("a plank at an oblique rotation") {
  Matrix oblique;
  oblique << 0.6, -0.8, 0, 0.8, 0.6, 0, 0, 0, 1;
  check_world(diagonal(1, 8, 8.5), oblique);
  Matrix three;
  three << 2, -1, 2, 2, 2, -1, -1, 2, 2;
  check_world(diagonal(1, 8, 8.5), three / 3);
}

TEST_CASE("random bodies agree with exact arithmetic") {
  generators::Random random(seed(0));
  const auto vector = [&](double low, double high) {
    return Vector{random.uniform(low, high), random.uniform(low, high), random.uniform(low, high)};
  };
  for (int asked = 0; asked < 100; ++asked) {
    const double mass = random.uniform(0.1, 9);
    const Vector size = vector(0.1, 4);
    check_box(mass, size);
    const Matrix box = diagonal(mass, size.x(), size.y());
    check_point(box, mass, vector(-3, 3));
    const double w = random.uniform(0.5, 1);
    check_world(box, rotation_of(w, vector(-1, 1)));
  }
}
