/// @file
/// Code to break: a box around points, along their principal axes.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <contact/prelude.hpp>

namespace given {

/// The terms are added from left to right.
inline double dot(const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
  return u.x() * v.x() + u.y() * v.y() + u.z() * v.z();
}

/// How the points are spread about their mean: the mean of d dᵀ over all points, with d the vector
/// from the mean to the point.
inline Eigen::Matrix3d covariance(const std::vector<Eigen::Vector3d>& points) {
  const auto count = static_cast<double>(points.size());
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points) mean += p / count;
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& p : points) {
    const Eigen::Vector3d d = p - mean;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) sum(i, j) += d[i] * d[j] / count;
  }
  return sum;
}

/// The eigenvectors of a symmetric matrix, as columns, by Jacobi's method: rotations about one axis
/// after the other make the numbers beside the diagonal zero. Those that are zero stay.
inline Eigen::Matrix3d eigenvectors(Eigen::Matrix3d m) {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  for (int sweep = 0; sweep < 20; ++sweep) {
    for (const auto& [i, j, k] : {std::array{0, 1, 2}, std::array{0, 2, 1}, std::array{1, 2, 0}}) {
      if (m(i, j) == 0) continue;
      const double theta = (m(j, j) - m(i, i)) / (2 * m(i, j));
      const double root = std::sqrt(theta * theta + 1);
      const double t = theta < 0 ? 1 / (theta - root) : 1 / (theta + root);
      const double c = 1 / std::sqrt(t * t + 1), s = t * c;
      const double ki = m(k, i), kj = m(k, j), tij = t * m(i, j);
      m(i, i) -= tij;
      m(j, j) += tij;
      m(i, j) = m(j, i) = 0;
      m(k, i) = m(i, k) = c * ki - s * kj;
      m(k, j) = m(j, k) = s * ki + c * kj;
      for (int row = 0; row < 3; ++row) {
        const double a = axes(row, i), b = axes(row, j);
        axes(row, i) = c * a - s * b;
        axes(row, j) = s * a + c * b;
      }
    }
  }
  return axes;
}

/// A box: its axes are the columns of a matrix, and its lengths are those along them.
struct Box {
  Eigen::Matrix3d axes;
  Eigen::Vector3d lengths;
};

/// A box around the points that should fit them well: along the principal axes, which are the
/// eigenvectors of the covariance.
inline Box principal_box(const std::vector<Eigen::Vector3d>& points) {
  Box box{eigenvectors(covariance(points)), {}};
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d axis = box.axes.col(i);
    double low = dot(axis, points.front()), high = low;
    for (const Eigen::Vector3d& p : points) {
      low = std::min(low, dot(axis, p));
      high = std::max(high, dot(axis, p));
    }
    box.lengths[i] = high - low;
  }
  return box;
}

/// The volume of the box.
inline double principal_volume(const std::vector<Eigen::Vector3d>& points) {
  const Box box = principal_box(points);
  return box.lengths.x() * box.lengths.y() * box.lengths.z();
}

}  // namespace given
