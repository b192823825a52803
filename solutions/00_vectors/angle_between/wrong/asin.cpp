// misconception: angle-by-asin
// caught by: obtuse angles
// seen: https://imathworks.com/math/angle-between-vectors-by-using-cross-product
//   the arcsine gives 18.42 degrees for an angle of 161.44
#include "angle_between.hpp"

namespace exercise {

double angle_between(const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
  if (u.norm() == 0 || v.norm() == 0) throw std::invalid_argument("u, v: one has no length");
  return std::asin(std::min(u.cross(v).norm() / (u.norm() * v.norm()), 1.0));
}

}  // namespace exercise
