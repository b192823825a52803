#include "break_the_parity.hpp"

namespace exercise {

// The ray leaves through the edge from (10, 3, 2) to (4, 3, 8), which counts twice.
Eigen::Vector3d inside_the_octahedron() { return {5, 3, 4}; }

// In through the diagonal of the left wall, which counts twice, and out through a triangle.
Eigen::Vector3d left_of_the_house() { return {-5, 2, 2}; }

// Below the edge from (8, -3, -6) to (-2, 7, -3), which has z = -4.8882 at this y before rounding.
Eigen::Vector3d past_every_edge() { return {-9, 0.706, -4.8882}; }

}  // namespace exercise
