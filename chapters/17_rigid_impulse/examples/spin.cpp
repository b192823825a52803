// A ball and a top rotate freely. The error of the orientation after a while, and the length of the
// longest column of a matrix that is not orthonormalised.
#include <contact/quaternion.hpp>
#include <contact/rotation.hpp>
#include <cstdio>

using M = contact::Matrix3<double>;
using V = contact::Vector3<double>;

/// The angle between two rotations. Over √2, the norm of their difference is its chord, 2 sin(δ/2).
double off(const M& got, const M& right) {
  return 2 * std::asin(std::fmin((got - right).norm() / std::sqrt(8.0), 1.0));
}

void angular_velocity(const char* name, const V& moments, const V& momentum) {
  const double h = 1.0 / 64;
  M plain = M::Identity();
  M tidy = M::Identity();
  contact::Quaternion<double> q;
  contact::Quaternion<double> x;
  contact::Quaternion<double> mid;
  const auto turn = [&](const M& r) {
    return contact::free_angular_velocity<double>(momentum, moments, r);
  };
  for (int step = 1; step <= 6400; ++step) {
    // The angular velocity is computed from an orthonormalised copy, or it would grow with the
    // matrix.
    plain = contact::matrix_step<double>(plain, turn(contact::orthonormalised<double>(plain)), h);
    tidy = contact::orthonormalised<double>(contact::matrix_step<double>(tidy, turn(tidy), h));
    q = contact::quaternion_step<double>(q, turn(contact::matrix_of(q)), h);
    x = contact::exponential_step<double>(x, turn(contact::matrix_of(x)), h);
    mid = contact::midpoint_step<double>(mid, momentum, moments, h);
    if (step != 64 && step != 640 && step != 6400) continue;
    const M right = contact::matrix_of(
        contact::free_top<double>({}, momentum, moments.x(), moments.z(), step * h));
    std::printf("%s %4d s  %8.2f  %8.5f  %8.5f  %11.5f  %8.5f\n", name, step / 64,
                plain.colwise().norm().maxCoeff(), off(tidy, right),
                off(contact::matrix_of(q), right), off(contact::matrix_of(x), right),
                off(contact::matrix_of(mid), right));
  }
}

int main() {
  std::printf("64 steps a second   errors in radians\n");
  std::printf("       time   length    matrix  quaternion  exponential  midpoint\n");
  angular_velocity("ball", V(1, 1, 1), V(0, 0, 3));
  angular_velocity("top ", V(1, 1, 0.5), V(1.8, 0, 1.2));
}
