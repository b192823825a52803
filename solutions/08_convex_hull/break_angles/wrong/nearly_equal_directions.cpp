// misconception: break-angles-far-apart
// caught by: no two points are in the same direction from the lowest
// seen: https://github.com/libgeos/geos/issues/722 points that are close to each other
#include "break_angles.hpp"

namespace exercise {

std::vector<Eigen::Vector2d> points_that_lose_a_vertex() {
  return {{0, 0}, {6, 0}, {3, 0}, {5, 5}};
}

std::vector<Eigen::Vector2d> points_with_an_extra_vertex() {
  return {{0, 0}, {6, 1}, {4, 4}, {2, 2}};
}

std::vector<Eigen::Vector2d> points_in_different_directions() {
  return {{0, 0}, {1001, 1000}, {1000, 999}, {0, 1000}};
}

}  // namespace exercise
