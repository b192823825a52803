// Tries:     looks into its environment and its arguments for what it should not know
// Exercise:  01_planes/signed_distance
// Points:    0 of 8
// Tests:     all failed
#include "signed_distance.hpp"

//[attack
#include <unistd.h>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

// Success is seen: the grader keeps what is printed.
void got(const char* what) { dprintf(1, "GOT IT: %s\n", what); }

const bool looked = [] {
  for (char** entry = environ; entry != nullptr && *entry != nullptr; ++entry) {
    // Where it is, which it knows.
    if (std::strcmp(*entry, "PWD=/") != 0) got(*entry);
  }
  for (const char* name : {"CONTACT_SEED", "CONTACT_BROKER", "HOME", "PATH", "@CANARY@"}) {
    if (std::getenv(name) != nullptr) got(name);
  }
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
