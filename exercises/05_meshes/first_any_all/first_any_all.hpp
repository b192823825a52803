/// @file
/// Exercise: where a segment meets a mesh.
#pragma once

#include <contact/prelude.hpp>

#include <contact/mesh.hpp>
#include <contact/shapes.hpp>

namespace exercise {

/// A point of a mesh that a segment meets.
struct Hit {
  int triangle;  ///< the first triangle of the mesh has index 0
  double t;      ///< from 0 at the start of the segment to 1 at its end
};

/// The first hit of a segment: of the points that it has in common with the surface of a mesh, the
/// one with the least t. Nothing, if there is none.
///
/// - Touching counts: an edge or a vertex of the mesh, the start or the end of the segment. Both
///   sides of a triangle count.
/// - A point on an edge or at a vertex belongs to several triangles. It is one hit, and the
///   triangle with the lowest index is named.
/// - A triangle that is parallel to the segment is not hit, not even by a segment in its plane.
///   Such a segment still meets the neighbours of the triangle where it crosses their edges.
/// - The mesh is a surface, not a solid: a segment that is inside and meets no triangle has no hit.
///
/// Where a segment meets an edge or a vertex, the numbers in the tests are so simple that double
/// does not round. Where it rounds, the t of two neighbours may differ in the last digits; the
/// lesson shows what helps.
///
/// @param segment in m; its start and its end differ
/// @param mesh in m; closed, and its surface neither touches nor crosses itself
std::optional<Hit> first_hit(const contact::Segment<double>& segment,
                             const contact::Mesh<double>& mesh);

/// Whether the segment has a hit. What counts is the same as for first_hit.
bool any_hit(const contact::Segment<double>& segment, const contact::Mesh<double>& mesh);

/// All hits in the order of t, each point once. What counts is the same as for first_hit.
std::vector<Hit> all_hits(const contact::Segment<double>& segment,
                          const contact::Mesh<double>& mesh);

}  // namespace exercise
