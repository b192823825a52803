// Tries:     calls itself without end
// Exercise:  01_planes/signed_distance
// Points:    4 of 8
// Tests:     1-3 passed, 4-6 stopped
// Says:      segmentation fault
#include "signed_distance.hpp"

//[attack
namespace {

// Not a loop that the compiler could make of it.
int deeper(volatile int* above) {
  volatile int here[1024] = {};
  here[0] = *above + 1;
  return deeper(here) + here[0];
}

}  // namespace
//]attack

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  volatile int start = 0;
  return deeper(&start);
  //]attack
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
