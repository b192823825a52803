// mistake: unknown-name
// alone
// says: its type comes first: int i = 0
#include "signed_distance.hpp"

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  double sum = plane.d;
  for (i = 0; i < 3; ++i) {  // here
    sum += point[i];
  }
  return sum;
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  return plane.a * point.x() > 0.0 ? 1 : -1;
}

}  // namespace exercise
