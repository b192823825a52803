// misconception: break-nearer-point-first
// caught by: no vertex is lost, and a point of an edge is returned
// seen: https://github.com/cp-algorithms/cp-algorithms/pull/1023
//   of equal angles the order that matters is reversed on the last ray
#include "break_angles.hpp"

namespace exercise {

std::vector<Eigen::Vector2d> points_that_lose_a_vertex() {
  return {{0, 0}, {6, 0}, {3, 0}, {5, 5}};
}

std::vector<Eigen::Vector2d> points_with_an_extra_vertex() {
  return {{0, 0}, {6, 1}, {2, 2}, {4, 4}};
}

std::vector<Eigen::Vector2d> points_in_different_directions() {
  return {{0, 0}, {0x1p29 + 1, 0x1p29}, {0x1p29, 0x1p29 - 1}, {0, 0x1p29}};
}

}  // namespace exercise
