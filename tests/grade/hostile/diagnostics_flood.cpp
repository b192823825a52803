// Tries:     makes the compiler print without end; its answers are right
// Exercise:  01_planes/signed_distance
// Points:    8 of 8
// Tests:     all passed
#include "signed_distance.hpp"

//[attack
#define ONE _Pragma("message(\"all work and no play makes Jack a dull boy\")")
#define TEN ONE ONE ONE ONE ONE ONE ONE ONE ONE ONE
#define MANY TEN TEN TEN TEN TEN TEN TEN TEN TEN TEN
MANY MANY MANY MANY MANY MANY MANY MANY MANY MANY
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
