// Tries:     prints without end
// Exercise:  01_planes/signed_distance
// Points:    4 of 8
// Tests:     1-3 passed, 4-6 stopped
// Says:      printed without end
#include "signed_distance.hpp"

//[attack
#include <cstdio>
//]attack

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  for (;;) std::puts("all work and no play makes Jack a dull boy");
  //]attack
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
