// misconception: break-no-equal-angles
// caught by: a vertex is lost, and every coordinate is a whole number up to 10
// seen: https://github.com/brian3kb/graham_scan_js/issues/8
//   four points in general position; it was not the sort
#include "break_angles.hpp"

namespace exercise {

std::vector<Eigen::Vector2d> points_that_lose_a_vertex() {
  return {{0, 0}, {6, 1}, {5, 5}, {1, 4}, {3, 2}};
}

std::vector<Eigen::Vector2d> points_with_an_extra_vertex() {
  return {{0, 0}, {6, 1}, {4, 4}, {1, 2}};
}

std::vector<Eigen::Vector2d> points_in_different_directions() {
  return {{0, 0}, {0x1p29 + 1, 0x1p29}, {0x1p29, 0x1p29 - 1}, {0, 0x1p29}};
}

}  // namespace exercise
