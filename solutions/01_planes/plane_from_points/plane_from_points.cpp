#include "plane_from_points.hpp"

namespace exercise {

contact::Plane<double> plane_from_points(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                         const Eigen::Vector3d& c) {
  const Eigen::Vector3d raw = (b - a).cross(c - a);
  // Only zero: a small cross product may belong to a small triangle.
  if (raw == Eigen::Vector3d::Zero()) {
    throw std::invalid_argument("a, b and c are on one line");
  }
  const Eigen::Vector3d normal = raw / raw.norm();
  return {normal, normal.dot(a)};
}

}  // namespace exercise
