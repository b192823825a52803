// misconception: normal-reversed
// caught by: the normal is on the side from which the points are counter-clockwise
// seen: https://github.com/OHIF/VTKPlugin/pull/25 the factors of a cross product are exchanged
#include "plane_from_points.hpp"

namespace exercise {

contact::Plane<double> plane_from_points(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                         const Eigen::Vector3d& c) {
  const Eigen::Vector3d raw = (c - a).cross(b - a);
  if (raw == Eigen::Vector3d::Zero()) {
    throw std::invalid_argument("a, b and c are on one line");
  }
  const Eigen::Vector3d normal = raw / raw.norm();
  return {normal, normal.dot(a)};
}

}  // namespace exercise
