/// @file
/// Exercise: point in any closed polyhedron.
///
/// All coordinates are whole numbers from -1000 to 1000, in m, so that a double holds every product
/// of up to four differences without rounding: the answers must be right for every input.
#pragma once

#include <contact/prelude.hpp>

#include <contact/mesh.hpp>

namespace exercise {

/// Where a point is of a polyhedron.
enum class Where { outside, on, inside };

/// Whether the point is on the triangle: inside it, on an edge or at a vertex.
///
/// @param triangle has an area
bool on_triangle(const Eigen::Vector3d& point, const contact::Triangle<double>& triangle);

/// Where the point is of the polyhedron: `on` is on a triangle.
///
/// @param mesh closed: each edge belongs to two triangles, in opposite directions. It may be
///   concave, and it may have several shells, which do not cross or touch: bodies beside each
///   other, and cavities within them. The vertices of each triangle are counter-clockwise, seen
///   from outside the body; in the wall of a cavity, seen from the cavity. Every triangle has an
///   area
/// @param point anywhere: a ray from it may meet an edge or a vertex, or lie in a triangle
Where inside_concave(const contact::Mesh<double>& mesh, const Eigen::Vector3d& point);

}  // namespace exercise
