// Tries:     says that its lines are those of a secret file, so that a message about them quotes
//            it
// Exercise:  01_planes/signed_distance
// Points:    0 of 8
// Tests:     does not compile
// Says:      not declared
#include "signed_distance.hpp"

//[attack
#line 1 "@SECRET@"
int first = nobody_declared_this;
#line 1 "/etc/passwd"
int second = nobody_declared_this;
//]attack

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
