#include "principal_axes.hpp"

namespace exercise {

// A cube with one corner cut off, as meshes of rounded bodies have it. Three vertices are there
// instead of one, so that the diagonal through this corner becomes an axis.
std::vector<Eigen::Vector3d> larger_than_the_aligned_box() {
  return {{0, 0, 0},   {10, 0, 0},  {0, 10, 0},  {0, 0, 10},  {10, 10, 0},
          {10, 0, 10}, {0, 10, 10}, {9, 10, 10}, {10, 9, 10}, {10, 10, 9}};
}

// A vertex of a cube that is stored twice, as a mesh with a normal for each face stores it. The
// covariance of the cube is the same in all directions, so one point decides.
Body changed_by_a_point() {
  return {{{0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {0, 0, 6}, {6, 6, 0}, {6, 0, 6}, {0, 6, 6}, {6, 6, 6}},
          {6, 6, 6}};
}

// Every direction is a principal axis of a cube, so the code takes x, y and z: its matrix is
// diagonal from the start. This cube is turned about z, by the triangle 3, 4, 5.
std::vector<Eigen::Vector3d> cube_in_a_large_box() {
  return {{0, 0, 0}, {4, 3, 0}, {-3, 4, 0}, {1, 7, 0}, {0, 0, 5}, {4, 3, 5}, {-3, 4, 5}, {1, 7, 5}};
}

}  // namespace exercise
