// misconception: degenerate-not-refused
// caught by: points on one line are refused
// seen: https://github.com/mathnet/mathnet-spatial/pull/20
//   points are only compared with each other, and a reviewer asks for the line
#include "plane_from_points.hpp"

namespace exercise {

contact::Plane<double> plane_from_points(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                         const Eigen::Vector3d& c) {
  const Eigen::Vector3d raw = (b - a).cross(c - a);
  const Eigen::Vector3d normal = raw / raw.norm();
  return {normal, normal.dot(a)};
}

}  // namespace exercise
