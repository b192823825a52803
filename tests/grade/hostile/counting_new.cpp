// Tries:     replaces operator new and malloc's hooks with honest ones; its answers are right
// Exercise:  01_planes/signed_distance
// Points:    8 of 8
// Tests:     all passed
#include "signed_distance.hpp"

//[attack
#include <cstdlib>
#include <new>

namespace {
std::size_t taken = 0;
}
void* operator new(std::size_t size) {
  taken += size;
  if (void* block = std::malloc(size)) return block;
  throw std::bad_alloc();
}
void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }
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
