// Tries:     is a program that needs more memory than there is before it starts
// Exercise:  01_planes/signed_distance
// Points:    0 of 8
// Tests:     all stopped or failed
#include "signed_distance.hpp"

//[attack
namespace {
char space[std::size_t{1} << 30];

}  // namespace
//]attack

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  return space[static_cast<std::size_t>(point.x())] + 1;
  //]attack
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  return space[static_cast<std::size_t>(point.x())] + 1;
  //]attack
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
