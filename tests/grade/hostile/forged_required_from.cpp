// Tries:     has a message say that it is required from a column of four hundred million, so that
// an
//            excerpt is as wide
// Exercise:  01_planes/signed_distance
// Points:    0 of 8
// Tests:     does not compile
// Says:      error
#include "signed_distance.hpp"

//[attack
asm(".error \"x\n01_planes/signed_distance.cpp:9:400000000:   required from "
    "here\n/usr/include/c++/12/vector:1:1: error: no match for 'operator='\n\"");
asm(".error \"x\n01_planes/signed_distance.cpp:9:9223372036854775807:   required from "
    "here\n/usr/include/c++/12/vector:1:1: error: 'x' was not declared in this scope\n\"");
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
