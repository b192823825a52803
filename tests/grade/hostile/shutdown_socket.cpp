// Tries:     shuts its end of the socket down and sleeps
// Exercise:  01_planes/signed_distance
// Points:    7 of 8
// Tests:     1-3 passed, 4 stopped, 5-6 passed
// Says:      waited for 1 second in all and did nothing
// Seconds:   10
#include "signed_distance.hpp"

//[attack
#include <sys/socket.h>
#include <unistd.h>
//]attack

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  if (plane.d == 14) shutdown(3, SHUT_RDWR);
  while (plane.d == 14) sleep(1000);
  //]attack
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
