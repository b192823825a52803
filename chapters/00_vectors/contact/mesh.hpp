/// @file
/// Triangle meshes as plain data. This header has no algorithms, so that an exercise's contract can
/// use a mesh without giving away the solution.
#pragma once

#include <array>
#include <contact/shapes.hpp>
#include <contact/vector.hpp>
#include <cstddef>
#include <vector>

namespace contact {

// [mesh]
/// An indexed triangle mesh: each vertex is stored once, and the triangles refer to it by its
/// index.
///
/// Seen from outside, the vertices of a triangle are counter-clockwise. A mesh need not be closed;
/// functions that require it say so, and `check_mesh` finds what is wrong and where. An index that
/// is out of range is an error of the program everywhere else.
template <Ring S>
struct Mesh {
  std::vector<Vector3<S>> vertices;           ///< m
  std::vector<std::array<int, 3>> triangles;  ///< three indices of vertices each
};
// [/mesh]

/// Triangle i with its vertices.
template <Ring S>
Triangle<S> triangle_of(const Mesh<S>& mesh, std::size_t i) {
  const auto& [a, b, c] = mesh.triangles[i];
  const auto at = [&mesh](int vertex) { return mesh.vertices[static_cast<std::size_t>(vertex)]; };
  return {at(a), at(b), at(c)};
}

/// A mesh from two lists of numbers: x, y and z of each vertex, and three indices for each
/// triangle.
/// @param coordinates m, three for each vertex; numbers beyond the last whole vertex are left out
/// @param indices whole numbers, three for each triangle; the same
template <class Coordinates, class Indices>
Mesh<double> mesh_from_lists(const Coordinates& coordinates, const Indices& indices) {
  Mesh<double> mesh;
  for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3) {
    mesh.vertices.push_back({coordinates[i], coordinates[i + 1], coordinates[i + 2]});
  }
  const auto index = [&indices](std::size_t i) { return static_cast<int>(indices[i]); };
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    mesh.triangles.push_back({index(i), index(i + 1), index(i + 2)});
  }
  return mesh;
}

}  // namespace contact
