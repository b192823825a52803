// mistake: unknown-name
// alone
// says: double d = 
#include "signed_distance.hpp"

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  d = plane.a * point.x();  // here
  return d;
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  return plane.a * point.x() > 0.0 ? 1 : -1;
}

}  // namespace exercise
