/// @file
/// Code to break: whether a point is inside a closed mesh.
#pragma once

#include <cstddef>

#include <contact/prelude.hpp>

#include <contact/mesh.hpp>

namespace given {

/// 8 triangles; its centre is (4, 3, 2), and each vertex is 6 from it along an axis.
inline contact::Mesh<double> octahedron() {
  return {{{10, 3, 2}, {-2, 3, 2}, {4, 9, 2}, {4, -3, 2}, {4, 3, 8}, {4, 3, -4}},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

/// A box of 4 × 6 × 3 with a roof: its ridge is along y, from (2, 0, 5) to (2, 6, 5).
inline contact::Mesh<double> house() {
  return {{{0, 0, 0},
           {4, 0, 0},
           {4, 0, 3},
           {2, 0, 5},
           {0, 0, 3},
           {0, 6, 0},
           {4, 6, 0},
           {4, 6, 3},
           {2, 6, 5},
           {0, 6, 3}},
          {{0, 1, 2},
           {0, 2, 4},
           {2, 3, 4},
           {5, 7, 6},
           {5, 9, 7},
           {7, 9, 8},
           {0, 5, 6},
           {0, 6, 1},
           {1, 6, 7},
           {1, 7, 2},
           {2, 7, 8},
           {2, 8, 3},
           {3, 8, 9},
           {3, 9, 4},
           {4, 9, 5},
           {4, 5, 0}}};
}

/// A tetrahedron.
inline contact::Mesh<double> shard() {
  return {{{-7, -5, -4}, {8, -3, -6}, {-2, 7, -3}, {1, -1, 9}},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

/// The terms are added from left to right.
inline double dot(const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
  return u.x() * v.x() + u.y() * v.y() + u.z() * v.z();
}

/// Whether the ray from the origin in the direction of +x meets the triangle, by Möller and
/// Trumbore. Its border belongs to the triangle.
inline bool meets(const Eigen::Vector3d& origin, const contact::Triangle<double>& triangle) {
  const Eigen::Vector3d direction(1, 0, 0);
  const Eigen::Vector3d ab = triangle.b - triangle.a, ac = triangle.c - triangle.a;
  const Eigen::Vector3d p = direction.cross(ac);
  const double determinant = dot(ab, p);
  if (determinant == 0) return false;  // parallel
  const Eigen::Vector3d s = origin - triangle.a;
  const double u = dot(s, p) / determinant;
  if (u < 0 || u > 1) return false;
  const Eigen::Vector3d q = s.cross(ab);
  const double v = dot(direction, q) / determinant;
  if (v < 0 || u + v > 1) return false;
  return dot(ac, q) / determinant > 0;
}

/// How many triangles of the mesh the ray from the point in the direction of +x meets.
inline int count_met(const contact::Mesh<double>& mesh, const Eigen::Vector3d& point) {
  int met = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    met += meets(point, contact::triangle_of(mesh, i)) ? 1 : 0;
  return met;
}

/// Whether the point is inside: then the ray meets an odd number of triangles.
inline bool inside_by_parity(const contact::Mesh<double>& mesh, const Eigen::Vector3d& point) {
  return count_met(mesh, point) % 2 == 1;
}

}  // namespace given
