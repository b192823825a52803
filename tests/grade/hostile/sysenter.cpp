// Tries:     asks the kernel by the instruction sysenter
// Exercise:  01_planes/signed_distance
// Points:    0 of 8
// Tests:     all stopped
#include "signed_distance.hpp"

//[attack
namespace {

void ask() {
  long result = 2;  // fork of 32-bit programs
  asm volatile("push %%rbp\n\tmov %%rsp, %%rbp\n\tsysenter\n\tpop %%rbp"
               : "+a"(result)
               :
               : "memory", "rcx", "rdx");
}

}  // namespace
//]attack

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  ask();
  return 1;
  //]attack
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  ask();
  return 1;
  //]attack
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
