// Tries:     jumps out of the call to a place before main, and ends there with status 0
// Exercise:  01_planes/signed_distance
// Ordinary:  exit status 0
// Points:    0 of 8
// Tests:     all stopped
// Says:      exit code 0
#include "signed_distance.hpp"

//[attack
#include <unistd.h>
#include <csetjmp>

namespace {

std::jmp_buf before_main;

const bool marked = [] {
  if (setjmp(before_main) != 0) _exit(0);
  return true;
}();

}  // namespace
//]attack

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  std::longjmp(before_main, 1);
  //]attack
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  std::longjmp(before_main, 1);
  //]attack
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
