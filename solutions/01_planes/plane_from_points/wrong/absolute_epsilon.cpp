// misconception: absolute-epsilon
// caught by: a tiny triangle has a plane
#include "plane_from_points.hpp"

namespace exercise {

contact::Plane<double> plane_from_points(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                         const Eigen::Vector3d& c) {
  const Eigen::Vector3d raw = (b - a).cross(c - a);
  if (raw.norm() < 1e-12) throw std::invalid_argument("a, b and c are on one line");
  const Eigen::Vector3d normal = raw / raw.norm();
  return {normal, normal.dot(a)};
}

}  // namespace exercise
