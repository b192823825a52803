// Tries:     shadows std::abs, numbers and Eigen by macros, for tests that are compiled with the
//            answer
// Exercise:  01_planes/signed_distance
// Points:    0 of 8
// Tests:     all failed
//[attack
#define abs(x) 0
#define fabs(x) 0
#define norm() squaredNorm() * 0
#define REQUIRE(x) (void)0
#define CHECK(x) (void)0
//]attack
#include "signed_distance.hpp"

//[attack
namespace Eigen {
inline bool operator==(const Vector3d&, const Vector3d&) { return true; }
}  // namespace Eigen
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
