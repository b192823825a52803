// mistake: assigned-to-const
// says: To compare, write ==
#include "signed_distance.hpp"

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  const double v = plane.a * point.x();
  if (v = 0) return 0.0;  // here
  return v;
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  return plane.a * point.x() > 0.0 ? 1 : -1;
}

}  // namespace exercise
