// mistake: missing-brace
// says: before line 11: the function's { of line 8 is still open there
// alone
#include "signed_distance.hpp"

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  return plane.a * point.x();  // here

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  return plane.a * point.x() > 0.0 ? 1 : -1;
}

}
