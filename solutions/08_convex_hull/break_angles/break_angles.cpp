#include "break_angles.hpp"

namespace exercise {

// On the first ray from the lowest point the farther point comes first in the list, so it is
// visited first. The nearer one, visited next, does not turn left and removes it.
std::vector<Eigen::Vector2d> points_that_lose_a_vertex() {
  return {{0, 0}, {6, 0}, {3, 0}, {5, 5}};
}

// On the last ray the nearer point should be visited first. Visited last it stays, in the interior
// of the edge that closes the hull.
std::vector<Eigen::Vector2d> points_with_an_extra_vertex() {
  return {{0, 0}, {6, 1}, {4, 4}, {2, 2}};
}

// The angles of the second and the third point differ by about 2e-18, less than the spacing of
// doubles, so both get the same one. Then the order of the list counts, and it is the wrong one.
std::vector<Eigen::Vector2d> points_in_different_directions() {
  const double n = 0x1p29;
  return {{0, 0}, {n + 1, n}, {n, n - 1}, {0, n}};
}

}  // namespace exercise
