// Tries:     naps before every fourth answer, which is right: slow, but not idle for long
// Exercise:  01_planes/signed_distance
// Points:    8 of 8
// Tests:     all passed
// Seconds:   10
#include "signed_distance.hpp"

//[attack
#include <ctime>

namespace {

void nap() {
  static int calls = 0;
  if (++calls % 4 != 0) return;
  const timespec half_a_millisecond{0, 500'000};
  nanosleep(&half_a_millisecond, nullptr);
}

}  // namespace
//]attack

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  nap();
  //]attack
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  nap();
  //]attack
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
