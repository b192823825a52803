// Tries:     takes memory and writes to it until there is none
// Exercise:  01_planes/signed_distance
// Points:    4 of 8
// Tests:     1-3 passed, 4-6 stopped
// Says:      memory
#include "signed_distance.hpp"

namespace exercise {

double signed_distance(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  const Eigen::Vector3d normal(plane.a, plane.b, plane.c);
  return (normal.dot(point) + plane.d) / normal.norm();
}

int side(const PlaneEquation& plane, const Eigen::Vector3d& point) {
  //[attack
  std::vector<std::vector<char>> all;
  for (;;) all.emplace_back(std::size_t{8} << 20, 'x');
  //]attack
  const double value = Eigen::Vector3d(plane.a, plane.b, plane.c).dot(point) + plane.d;
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

}  // namespace exercise
