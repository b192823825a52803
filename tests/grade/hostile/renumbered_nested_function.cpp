// Tries:     numbers its lines up to the largest number, so that a search for the function around
//            a message never ends
// Exercise:  01_planes/signed_distance
// Points:    0 of 8
// Tests:     does not compile
// Says:      function
#include "signed_distance.hpp"

//[attack
void around() {
#line 2147483647
  void within() {}
}
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
