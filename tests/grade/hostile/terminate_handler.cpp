// Tries:     handles std::terminate, abort and the end of the program by ending with status 0
// Exercise:  01_planes/signed_distance
// Ordinary:  exit status 0
// Points:    0 of 8
// Tests:     all stopped
// Says:      exit code 0
#include "signed_distance.hpp"

//[attack
#include <unistd.h>
#include <csignal>
#include <cstdlib>
#include <exception>

namespace {

void out() noexcept(false) {
  std::set_terminate([] { _exit(0); });
  std::signal(
      SIGABRT, +[](int) { _exit(0); });
  std::atexit([] { _exit(0); });
  []() noexcept { throw 1; }();
}

}  // namespace
//]attack

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  out();
  //]attack
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  out();
  //]attack
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
