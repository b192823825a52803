// Tries:     takes requests off the socket itself, so that server and tests no longer agree
// Exercise:  01_planes/signed_distance
// Points:    0 of 8
// Tests:     all stopped or failed
#include "signed_distance.hpp"

//[attack
#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>
//]attack

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  // The next request is not there before this one is answered: nothing to be had.
  char bytes[4096];
  recv(3, bytes, sizeof bytes, MSG_DONTWAIT | MSG_PEEK);
  fcntl(3, F_SETFL, O_NONBLOCK);
  return 1;
  //]attack
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  fcntl(3, F_SETFL, O_NONBLOCK);
  return 1;
  //]attack
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
