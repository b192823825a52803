// Tries:     locks a mutex that it holds already: a common mistake
// Exercise:  01_planes/signed_distance
// Points:    7 of 8
// Tests:     1-3 passed, 4 stopped, 5-6 passed
// Says:      waited for 1 second in all and did nothing
// Seconds:   10
#include "signed_distance.hpp"

//[attack
#include <mutex>

namespace {

std::mutex mutex;

}  // namespace
//]attack

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  const std::lock_guard<std::mutex> first(mutex);
  if (plane.d == 14) mutex.lock();
  //]attack
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
