// misconception: degrees-returned
// caught by: right angles, and none
// seen: https://github.com/CreedVI/Raylib-J/issues/55
#include "angle_between.hpp"

namespace exercise {

double angle_between(const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
  if (u.norm() == 0 || v.norm() == 0) throw std::invalid_argument("u, v: one has no length");
  return std::atan2(u.cross(v).norm(), u.dot(v)) * 180 / std::numbers::pi;
}

}  // namespace exercise
