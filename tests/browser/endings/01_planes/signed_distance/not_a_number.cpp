// Reads a number from a text that holds none.
#include "signed_distance.hpp"

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  return plane.d + std::stod(point.x() < 1e300 ? "seven" : "7");
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  const double value = plane.a * point.x() + plane.b * point.y() + plane.c * point.z() + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
