// Tries:     sleeps before main, so that each of its tests only waits
// Exercise:  01_planes/signed_distance
// Points:    0 of 8
// Tests:     all stopped
// Says:      waited for 1 second in all | waited for 0.1 seconds in all
// Seconds:   10
#include "signed_distance.hpp"

//[attack
#include <unistd.h>

namespace {

const bool slept = [] {
  for (;;) sleep(1000);
  return true;
}();

}  // namespace
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
