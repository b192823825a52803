// Tries:     replaces functions of the C library that server and tests call: what is compared,
//            sent and received
// Exercise:  01_planes/signed_distance
// Points:    0 of 8
// Tests:     all stopped or failed
#include "signed_distance.hpp"

//[attack
#include <sys/types.h>
#include <cerrno>
#include <cstddef>
#include <cstring>

extern "C" {
int memcmp(const void*, const void*, std::size_t) { return 0; }
int strcmp(const char*, const char*) { return 0; }
ssize_t send(int, const void*, std::size_t, int) {
  errno = EPIPE;
  return -1;
}
}
//]attack

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  return 1;
  //]attack
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  return 1;
  //]attack
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
