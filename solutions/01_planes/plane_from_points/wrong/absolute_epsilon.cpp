// misconception: absolute-epsilon
// caught by: a tiny triangle has a plane
// seen: https://github.com/func-godot/func_godot_plugin/pull/73
//   planes with a small cross product are skipped
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
