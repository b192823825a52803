// misconception: angle-by-acos
// caught by: small angles, and angles near π, are accurate
// seen: https://github.com/godotengine/godot/pull/8132
//   the arccosine of a quotient is replaced by atan2
#include "angle_between.hpp"

namespace exercise {

double angle_between(const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
  if (u.norm() == 0 || v.norm() == 0) throw std::invalid_argument("u, v: one has no length");
  return std::acos(std::clamp(u.dot(v) / (u.norm() * v.norm()), -1.0, 1.0));
}

}  // namespace exercise
