// Tries:     turns rounding upwards and small numbers into zero, for tests that calculate in the
//            same process; then answers rightly
// Exercise:  01_planes/signed_distance
// Points:    8 of 8
// Tests:     all passed
#include "signed_distance.hpp"

//[attack
#include <xmmintrin.h>
#include <cfenv>

namespace {

void spoil() {
  std::fesetround(FE_UPWARD);
  _mm_setcsr(_mm_getcsr() | 0x8040);  // flush to zero, denormals are zero
}

}  // namespace
//]attack

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  spoil();
  //]attack
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  spoil();
  //]attack
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
