// Tries:     writes over the tables of virtual functions of exceptions and streams and throws
// Exercise:  01_planes/signed_distance
// Points:    0 of 8
// Tests:     all stopped or failed
#include "signed_distance.hpp"

//[attack
#include <sys/mman.h>
#include <cstring>
#include <iostream>
#include <stdexcept>

namespace {

void patch() {
  std::runtime_error error("passed");
  void** table = *reinterpret_cast<void***>(&error);
  const auto page = reinterpret_cast<std::uintptr_t>(table) & ~std::uintptr_t{4095};
  mprotect(reinterpret_cast<void*>(page), 8192, PROT_READ | PROT_WRITE);
  table[2] = table[0];
  throw error;
}

}  // namespace
//]attack

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  patch();
  //]attack
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  patch();
  //]attack
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
