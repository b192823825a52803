// misconception: quadrant-lost
// caught by: obtuse angles
// seen: https://james-bern.github.io/notes.html the arctangent of y / x is 45° for (−1, −1) too
#include "angle_between.hpp"

namespace exercise {

double angle_between(const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
  if (u.norm() == 0 || v.norm() == 0) throw std::invalid_argument("u, v: one has no length");
  return std::atan(u.cross(v).norm() / u.dot(v));
}

}  // namespace exercise
