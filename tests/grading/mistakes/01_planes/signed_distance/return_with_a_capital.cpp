// mistake: capital-letter
// alone
// says: return is written small
#include "signed_distance.hpp"

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  const double value = plane.a * point.x();
  Return value;  // here
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  return plane.a * point.x() > 0.0 ? 1 : -1;
}

}  // namespace exercise
