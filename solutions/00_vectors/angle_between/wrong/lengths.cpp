// misconception: lengths-forgotten
// caught by: obtuse angles
// seen: https://github.com/raysan5/raylib/pull/2831 the arccosine of a dot product
#include "angle_between.hpp"

namespace exercise {

double angle_between(const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
  if (u.norm() == 0 || v.norm() == 0) throw std::invalid_argument("u, v: one has no length");
  return std::acos(u.dot(v));
}

}  // namespace exercise
