// mistake: wrong-type
// says: C++ cannot turn a vector (Eigen::Vector3d) into a number (double).
#include "signed_distance.hpp"

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  double d = (point - normal).cross(point);  // here
  return plane.d + d;
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  return plane.a * point.x() > 0.0 ? 1 : -1;
}

}  // namespace exercise
