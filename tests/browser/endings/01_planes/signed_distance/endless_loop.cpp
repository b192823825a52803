// Never ends.
#include "signed_distance.hpp"

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  // For one point only: a test that never ends costs its whole time limit.
  volatile bool forever = point.x() == 5 && point.z() == 4;
  while (forever) {
  }
  return plane.d + point.x();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  const double value = plane.a * point.x() + plane.b * point.y() + plane.c * point.z() + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
