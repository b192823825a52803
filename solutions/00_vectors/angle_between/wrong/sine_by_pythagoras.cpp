// misconception: none
// caught by: small angles, and angles near π, are accurate
#include "angle_between.hpp"

namespace exercise {

double angle_between(const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
  if (u.norm() == 0 || v.norm() == 0) throw std::invalid_argument("u, v: one has no length");
  const double along = u.dot(v);
  return std::atan2(std::sqrt(u.squaredNorm() * v.squaredNorm() - along * along), along);
}

}  // namespace exercise
