/// @file
/// Exercise: the contact of an edge of one body with an edge of another.
///
/// All coordinates are whole numbers from -1000 to 1000, in m. So a double holds every difference
/// of two positions, every cross product of two differences, and every dot product of a difference
/// or a cross product with a cross product, without rounding: whether edges meet must be decided
/// right for every input. Only the position and the normal of a contact are rounded, and may be off
/// by 1e-9 in each coordinate.
#pragma once

#include <contact/prelude.hpp>

#include <contact/shapes.hpp>

namespace exercise {

/// Where an edge of a body A touches an edge of a body B.
struct EdgeContact {
  Eigen::Vector3d position;  ///< m
  Eigen::Vector3d normal;    ///< unit vector, perpendicular to both edges, from B to A
};

/// Whether a plane contains both edges. Then the tetrahedron of their four ends has no volume.
/// Parallel edges lie in one plane, and so do edges whose lines cross.
/// @param a in m; its start and its end differ
/// @param b the same
bool in_one_plane(const contact::Segment<double>& a, const contact::Segment<double>& b);

/// Whether the edges have a point in common. The ends belong to an edge, so touching counts.
/// Parallel edges meet if they are on one line and touch or overlap.
/// @param a, b as in in_one_plane
bool edges_meet(const contact::Segment<double>& a, const contact::Segment<double>& b);

/// The contact of an edge of A with an edge of B: nothing, if the edges do not meet. Nothing, too,
/// if they are parallel: then no normal is determined by them.
///
/// An end counts as any other point of its edge.
///
/// @param a, b as in in_one_plane
/// @param inside_b a point inside B, m. It is not in the plane of the two edges. B is on its side
///   of this plane, and A on the other
std::optional<EdgeContact> edge_contact(const contact::Segment<double>& a,
                                        const contact::Segment<double>& b,
                                        const Eigen::Vector3d& inside_b);

}  // namespace exercise
