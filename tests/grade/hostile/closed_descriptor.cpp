// Tries:     closes the socket, opens other things in its place, and works on
// Exercise:  01_planes/signed_distance
// Points:    0 of 8
// Tests:     all stopped
// Says:      connection|exit code
#include "signed_distance.hpp"

//[attack
#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

namespace {

const bool closed = [] {
  close(3);
  int ends[2];
  if (pipe(ends) == 0) dup2(ends[0], 3);
  if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends) == 0) dup2(ends[0], 3);
  return true;
}();

}  // namespace
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
