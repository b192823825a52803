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

// The three functions are about the points that the segment and the surface of the mesh have in
// common.
//
// - Touching counts: an edge or a vertex of the mesh, the start or the end of the segment. Both
//   sides of a triangle count.
// - A point on an edge or at a vertex belongs to several triangles. It is one hit, and the triangle
//   with the lowest index is named.
// - A triangle that is parallel to the segment is not hit, even if the segment is in its plane.
// Such
//   a segment still meets the neighbours of the triangle where it crosses their edges.
// - The mesh is a surface, not a solid: a segment that is inside and meets no triangle has no hit.
//
// The mesh is closed, and its surface neither touches nor crosses itself. The start and the end of
// the segment differ. Where a segment meets an edge or a vertex, the numbers in the tests are so
// simple that double does not round. Where it rounds, the t of two neighbours may differ in the
// last digits; the lesson shows what helps.

/// The hit with the least t. Nothing, if there is none.
/// @param segment in m
/// @param mesh in m
std::optional<Hit> first_hit(const contact::Segment<double>& segment,
                             const contact::Mesh<double>& mesh);

/// Whether there is a hit.
bool any_hit(const contact::Segment<double>& segment, const contact::Mesh<double>& mesh);

/// All hits in the order of t.
std::vector<Hit> all_hits(const contact::Segment<double>& segment,
                          const contact::Mesh<double>& mesh);

}  // namespace exercise
