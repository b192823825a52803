// Lets an exception out.
#include "signed_distance.hpp"

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  if (point.x() < 1e300) throw std::runtime_error("not today");
  return plane.d;
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  const double value = plane.a * point.x() + plane.b * point.y() + plane.c * point.z() + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
