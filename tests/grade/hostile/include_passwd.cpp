// Tries:     includes the list of users, so that the compiler's message shows it
// Exercise:  01_planes/signed_distance
// Points:    0 of 8
// Tests:     does not compile
// Says:      No such file|denied
// Reduced:   what other users may read is seen
//[attack
#include "/etc/passwd"
//]attack
#include "signed_distance.hpp"

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
