/// @file
/// Exercise: point in a convex polyhedron by the planes of its faces.
///
/// All coordinates are whole numbers from -2^15 to 2^15, in m, so that a double holds every
/// difference, every cross product of two of them and its dot product with a third without
/// rounding: the answers must be right for every input.
#pragma once

#include <contact/prelude.hpp>

#include <contact/mesh.hpp>

namespace exercise {

/// Where a point is of a polyhedron.
enum class Where { outside, on, inside };

/// The outward normal of a face: perpendicular to it, pointing out of the polyhedron, and as long
/// as twice the face's area. Zero, if the three vertices are on one line.
///
/// @param face a, b and c are counter-clockwise, seen from outside
Eigen::Vector3d outward_normal(const contact::Triangle<double>& face);

/// The dot product of this normal and the vector from the face to the point: positive in front of
/// the face, zero in its plane, negative behind it.
///
/// @param point anywhere
double ahead(const Eigen::Vector3d& point, const contact::Triangle<double>& face);

/// Where the point is of a convex polyhedron: `on` is on a face, on an edge or at a vertex.
///
/// @param mesh closed and convex; the vertices of each triangle are counter-clockwise, seen from
///   outside. Neighbouring triangles may be in one plane. A triangle may be without area, its
///   vertices on one line: where a vertex is inside the edge of a neighbour, such triangles close
///   the mesh
/// @param point anywhere
Where inside_convex(const contact::Mesh<double>& mesh, const Eigen::Vector3d& point);

}  // namespace exercise
