// Tries:     runs code before main, before the constructors and after main, which sends, prints
//            and never ends; its answers are right
// Exercise:  01_planes/signed_distance
// Points:    8 of 8
// Tests:     all passed
#include "signed_distance.hpp"

//[attack
#include <unistd.h>
#include <cstdio>
#include <cstdlib>

namespace {

__attribute__((constructor(101))) void first() {
  std::atexit([] {
    for (;;) pause();
  });
}
void earliest() { dprintf(1, "before everything\n"); }
__attribute__((section(".preinit_array"), used)) void (*const before)() = earliest;
__attribute__((destructor)) void last() {
  dprintf(3, "passed");
  for (;;) pause();
}

}  // namespace
//]attack

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
