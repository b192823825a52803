// mistake: name-in-comment
// alone
// says: Its name stands in a comment on line 8: take the /* and */ away.
#include "signed_distance.hpp"

namespace exercise {

double signed_distance(const PlaneEquation& /*plane*/, const Eigen::Vector3d& point) {
  return plane.a * point.x();  // here
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  return plane.a * point.x() > 0.0 ? 1 : -1;
}

}  // namespace exercise
