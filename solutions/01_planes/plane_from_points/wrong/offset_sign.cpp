// misconception: offset-sign
// caught by: the offset is the signed distance of the plane from the origin
// seen: https://github.com/cheind/parsley/issues/3
//   the plane keeps its constant with the opposite sign
#include "plane_from_points.hpp"

namespace exercise {

contact::Plane<double> plane_from_points(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                         const Eigen::Vector3d& c) {
  const Eigen::Vector3d raw = (b - a).cross(c - a);
  if (raw == Eigen::Vector3d::Zero()) {
    throw std::invalid_argument("a, b and c are on one line");
  }
  const Eigen::Vector3d normal = raw / raw.norm();
  return {normal, -normal.dot(a)};
}

}  // namespace exercise
