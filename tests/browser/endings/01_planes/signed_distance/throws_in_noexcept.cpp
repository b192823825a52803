// Lets an exception out of a noexcept function.
#include "signed_distance.hpp"

#include <stdexcept>

double sure(double x) noexcept {
  if (x < 1e300) throw std::runtime_error("not today");
  return x;
}

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  return plane.d + sure(point.x());
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  const double value = plane.a * point.x() + plane.b * point.y() + plane.c * point.z() + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
