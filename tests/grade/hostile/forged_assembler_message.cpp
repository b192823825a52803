// Tries:     has the assembler print messages of a made-up place: a function within a function at
//            the last line that there can be
// Exercise:  01_planes/signed_distance
// Points:    0 of 8
// Tests:     does not compile
// Says:      compiler | error
#include "signed_distance.hpp"

//[attack
asm(".error \"x\n01_planes/signed_distance.cpp:2147483647:9: error: a function-definition is not "
    "allowed here before '{' token\n\"");
asm(".error \"x\n01_planes/signed_distance.cpp:2147483646:2147483646: error: stray '@' in "
    "program\n\"");
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
