// misconception: zero-angle-not-refused
// caught by: a vector without length is refused
// seen: https://github.com/compas-dev/compas/issues/1528
#include "angle_between.hpp"

namespace exercise {

double angle_between(const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

}  // namespace exercise
