/// @file
/// What can be wrong with a mesh, as data and in words.
#pragma once

#include <array>
#include <concepts>
#include <contact/invalid_argument.hpp>
#include <contact/mesh.hpp>
#include <cstddef>
#include <string>
#include <vector>

namespace contact {

/// What can be wrong with a mesh.
enum class MeshFaultKind {
  index_out_of_range,    ///< a triangle refers to a vertex that does not exist
  vertex_not_finite,     ///< a coordinate is an infinity or NaN
  repeated_index,        ///< a triangle has the same vertex twice
  no_area,               ///< a triangle's three vertices are exactly collinear
  same_triangle,         ///< several triangles have the same three vertices, in whatever order
  boundary_edge,         ///< an edge of one triangle alone: the surface ends there
  crowded_edge,          ///< an edge of more than two triangles
  same_direction,        ///< neighbours run through their edge in the same direction
  several_fans,          ///< the triangles at a vertex are not all joined by edges at it
  unused_vertex,         ///< a vertex of no triangle
  equal_vertices,        ///< the same position is stored several times
  component_inside_out,  ///< a closed component has its front inside
  component_no_volume    ///< a closed component has a volume of exactly 0
};

/// One fault, and where it is. What does not apply is empty.
struct MeshFault {
  MeshFaultKind kind = MeshFaultKind::index_out_of_range;  ///< what is wrong
  std::vector<int> triangles;  ///< the triangles that take part, in increasing order
  std::vector<int> vertices;   ///< the vertex, the two of the edge, or all equal ones, likewise
};

/// A fault in words, in English: "edge 0-1 from (0, 0, 0) to (1, 0, 0) belongs to triangle 3 alone:
/// the surface ends there".
/// A coordinate that is not finite is written as "nan" or "inf", some with a minus sign.
/// @param fault as `check_mesh` found it: one that names too little is an error of the program
/// @param mesh the one that was checked
template <std::floating_point S>
std::string text(const MeshFault& fault, const Mesh<S>& mesh) {
  const auto list = [](const std::vector<int>& numbers) {
    std::string result;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (i > 0) result += i + 1 < numbers.size() ? ", " : " and ";
      result += std::to_string(numbers[i]);
    }
    return result;
  };
  const auto position = [&mesh](int v) {
    return vector_text(mesh.vertices[static_cast<std::size_t>(v)]);
  };
  const std::string triangles =
      (fault.triangles.size() == 1 ? "triangle " : "triangles ") + list(fault.triangles);
  const std::string vertices =
      (fault.vertices.size() == 1 ? "vertex " : "vertices ") + list(fault.vertices);
  const auto edge = [&] {
    return "edge " + std::to_string(fault.vertices[0]) + "-" + std::to_string(fault.vertices[1]) +
           " from " + position(fault.vertices[0]) + " to " + position(fault.vertices[1]);
  };
  const auto corners = [&] {
    const std::array<int, 3>& t = mesh.triangles[static_cast<std::size_t>(fault.triangles[0])];
    return list({t.begin(), t.end()});
  };
  const auto component = [&] {
    return "the component of triangle " + std::to_string(fault.triangles[0]) + " (" +
           std::to_string(fault.triangles.size()) + " triangles) ";
  };
  switch (fault.kind) {
    case MeshFaultKind::index_out_of_range:
      return triangles + " refers to vertices " + corners() + ", but there are only " +
             std::to_string(mesh.vertices.size()) + " vertices";
    case MeshFaultKind::vertex_not_finite:
      return vertices + " is not finite: " + position(fault.vertices[0]);
    case MeshFaultKind::repeated_index:
      return triangles + " has a vertex twice: " + corners();
    case MeshFaultKind::no_area:
      return triangles + " has no area: its vertices " + corners() + " are on one line";
    case MeshFaultKind::same_triangle:
      return triangles + " have the same " + vertices;
    case MeshFaultKind::boundary_edge:
      return edge() + " belongs to " + triangles + " alone: the surface ends there";
    case MeshFaultKind::crowded_edge:
      return edge() + " belongs to " + std::to_string(fault.triangles.size()) +
             " triangles: " + list(fault.triangles);
    case MeshFaultKind::same_direction:
      return fault.triangles.size() == 2
                 ? triangles + " run through " + edge() + " in the same direction"
                 : "of " + triangles + " not as many run through " + edge() +
                       " one way as the other";
    case MeshFaultKind::several_fans:
      return "the triangles at " + vertices + " " + position(fault.vertices[0]) + " form " +
             std::to_string(fault.triangles.size()) +
             " fans; one of each: " + list(fault.triangles);
    case MeshFaultKind::unused_vertex:
      return vertices + " " + position(fault.vertices[0]) + " belongs to no triangle";
    case MeshFaultKind::equal_vertices:
      return vertices + " have the same position " + position(fault.vertices[0]);
    case MeshFaultKind::component_inside_out:
      return component() + "is inside out: its volume is negative";
    case MeshFaultKind::component_no_volume:
      return component() + "has no volume";
  }
  return {};
}

}  // namespace contact
