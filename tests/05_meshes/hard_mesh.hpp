/// @file
/// The mesh of a hard case.
#pragma once

#include <concepts>
#include <contact/mesh.hpp>
#include <contact/mesh_shapes.hpp>
#include <string>
#include <support/hard_cases.hpp>

namespace hard_mesh {

/// The vertices, x, y and z, and the indices of the triangles.
/// @param suffix of the names of the two lists, for a case with two meshes
inline contact::Mesh<double> mesh_of(const hard_cases::Case& c, const std::string& suffix = "") {
  return contact::mesh_from_lists(c.numbers("vertices" + suffix), c.numbers("triangles" + suffix));
}

/// The same in S.
template <std::floating_point S>
contact::Mesh<S> mesh_in(const hard_cases::Case& c) {
  return contact::rounded_mesh<S>(mesh_of(c));
}

}  // namespace hard_mesh
