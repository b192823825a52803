/// @file
/// Exercise: all contacts of two meshes, each once.
///
/// A mesh here is the surface of a body. It is closed: each edge belongs to two triangles, which
/// have it in opposite directions. Each triangle has an area, each vertex belongs to a triangle,
/// and the surface does not touch itself. All coordinates are whole numbers from -100 to 100, in m,
/// so that only the positions where two edges cross are rounded. These may be off by 1e-9 in each
/// coordinate.
#pragma once

#include <contact/prelude.hpp>

#include <contact/mesh.hpp>

namespace exercise {

/// A vertex, an edge or a face of a mesh, named by the indices of its one, two or three vertices in
/// increasing order. The rest is -1: {7, -1, -1} is vertex 7, and {2, 7, -1} is an edge.
using Feature = std::array<int, 3>;

/// A point that two bodies A and B have in common, and the smallest feature of each that contains
/// it: a vertex rather than its edges, an edge rather than its faces.
struct MeshContact {
  Feature of_a;
  Feature of_b;
  Eigen::Vector3d position;  ///< m
};

/// The edges of the body, each once, in increasing order: {0, 2, -1} is before {0, 3, -1}, and that
/// is before {1, 2, -1}.
///
/// Where the two triangles of an edge lie in one plane, the edge is none of the body, because it
/// is inside a flat face, like the diagonal that divides a square.
std::vector<Feature> edges_of(const contact::Mesh<double>& mesh);

/// The smallest feature of the body that contains the point; nothing, if the point is not on the
/// surface.
///
/// A point on an edge that is none of the body is inside a face. Of the two triangles, the first
/// one in the list is named.
///
/// @param point with whole coordinates too
std::optional<Feature> feature_at(const contact::Mesh<double>& mesh, const Eigen::Vector3d& point);

/// The contacts of two bodies: each vertex of one that is on the surface of the other, and each
/// point where an edge of one crosses an edge of the other between their ends.
///
/// - Each contact is in the list once, however many triangles contain it. A vertex on a vertex is
///   one contact.
/// - Edges that are parallel do not cross, even if they overlap: the vertices at the ends of the
///   overlap are contacts already.
/// - The list is in increasing order of of_a, and of of_b where that is equal. Features are
///   compared as std::array does, index by index.
///
/// @param a, b the bodies touch or are apart: no point is inside both
std::vector<MeshContact> mesh_contacts(const contact::Mesh<double>& a,
                                       const contact::Mesh<double>& b);

}  // namespace exercise
