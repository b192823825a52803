// Tries:     maps memory in every way there is, ignores what is refused, then answers rightly;
//            the machine's other programs must not notice
// Exercise:  01_planes/signed_distance
// Points:    8 of 8
// Tests:     all passed or stopped
// Says:      memory
#include "signed_distance.hpp"

//[attack
#include <sys/mman.h>
#include <cstdlib>
#include <cstring>

namespace {

void bomb() {
  for (int i = 0; i < 200; ++i) {
    void* block = mmap(nullptr, std::size_t{64} << 20, PROT_READ | PROT_WRITE,
                       MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (block == MAP_FAILED) continue;
    std::memset(block, 1, std::size_t{64} << 20);
    mlock(block, std::size_t{64} << 20);
  }
}

}  // namespace
//]attack

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  [[maybe_unused]] static const bool once = (bomb(), true);
  //]attack
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
