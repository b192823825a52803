// mistake: chained-comparison
// says: a <= b && b <= c
#include "signed_distance.hpp"

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  if (0.0 <= plane.d <= 1.0) return 0.0;  // here
  return plane.a * point.x();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  return plane.a * point.x() > 0.0 ? 1 : -1;
}

}  // namespace exercise
