// Tries:     has every inexact result raise a signal
// Exercise:  01_planes/signed_distance
// Points:    0 of 8
// Tests:     all stopped
// Says:      floating|arithmetic|SIGFPE
#include "signed_distance.hpp"

//[attack
#include <fenv.h>
//]attack

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  feenableexcept(FE_ALL_EXCEPT);
  //]attack
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  feenableexcept(FE_ALL_EXCEPT);
  if (std::sqrt(point.x() * point.x() + 2) / 3 == 0) return 0;
  //]attack
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
