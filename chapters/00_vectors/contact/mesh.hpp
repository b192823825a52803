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
/// An indexed triangle mesh: each vertex is stored once, and the triangles refer to it by its index.
///
/// Seen from outside, the vertices of a triangle are counter-clockwise. A mesh need not be closed;
/// functions that require it say so, and `check_mesh` finds what is wrong and where. An index that
/// is out of range is an error of the program everywhere else.
template <Ring S>
struct Mesh {
  std::vector<Vector3<S>> vertices;           ///< m
  std::vector<std::array<int, 3>> triangles;  ///< three indices of vertices each
};

/// Triangle i with its vertices.
template <Ring S>
Triangle<S> triangle_of(const Mesh<S>& mesh, std::size_t i) {
  const auto& [a, b, c] = mesh.triangles[i];
  const auto at = [&mesh](int vertex) { return mesh.vertices[static_cast<std::size_t>(vertex)]; };
  return {at(a), at(b), at(c)};
}
// [/mesh]

}  // namespace contact
