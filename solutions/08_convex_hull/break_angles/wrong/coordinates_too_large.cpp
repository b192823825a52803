// misconception: break-outside-the-region
// caught by: a vertex is lost, and every coordinate is a whole number up to 10
// seen: https://github.com/opencv/opencv/issues/14521 a hull is wrong if coordinates are large
#include "break_angles.hpp"

namespace exercise {

std::vector<Eigen::Vector2d> points_that_lose_a_vertex() {
  return {{0, 0}, {60, 0}, {30, 0}, {50, 50}};
}

std::vector<Eigen::Vector2d> points_with_an_extra_vertex() {
  return {{0, 0}, {6, 1}, {4, 4}, {2, 2}};
}

std::vector<Eigen::Vector2d> points_in_different_directions() {
  return {{0, 0}, {0x1p29 + 1, 0x1p29}, {0x1p29, 0x1p29 - 1}, {0, 0x1p29}};
}

}  // namespace exercise
