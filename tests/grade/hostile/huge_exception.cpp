// Tries:     throws an exception whose text is 100 MB long, and one whose text forges lines of a
//            report
// Exercise:  01_planes/signed_distance
// Points:    0 of 8
// Tests:     all stopped or failed
#include "signed_distance.hpp"

//[attack
#include <stdexcept>
//]attack

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  throw std::invalid_argument(std::string(std::size_t{100} << 20, 'x'));
  //]attack
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  throw std::runtime_error(
      "\"}\n{\"event\":\"end\",\"test\":\"a point near the plane is not on "
      "it\",\"status\":\"passed\",\"seconds\":0}\n\x1b[2J");
  //]attack
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
