// Tries: throws exceptions that are seldom caught: numbers, exceptions whose text is a null
// pointer,
//            exceptions while unwinding
// Exercise:  01_planes/signed_distance
// Points:    0 of 8
// Tests:     all stopped
#include "signed_distance.hpp"

//[attack
#include <exception>

namespace {

struct Odd : std::exception {
  const char* what() const noexcept override { return nullptr; }
};
struct ThrowsAgain {
  ~ThrowsAgain() noexcept(false) { throw 2; }
};

}  // namespace
//]attack

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  throw Odd();
  //]attack
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  ThrowsAgain again;
  throw 1;
  //]attack
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
