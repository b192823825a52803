#include "angle_between.hpp"

namespace exercise {

double angle_between(const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
  //? A vector of length zero has no direction, so there is no angle to return.
  //? gap: v.norm() == 0
  if (u.norm() == 0 || v.norm() == 0) throw std::invalid_argument("u, v: one has no length");
  //? The sine and the cosine of the angle have the same factor |u||v|, so atan2 needs no division.
  //? Unlike acos it is accurate near 0 and π.
  //? gap: u.cross(v).norm()
  //? gap: u.dot(v)
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

}  // namespace exercise
