/// @file
/// Exercise: two triangles in one plane.
///
/// All coordinates are whole numbers from -2000 to 2000, in m, so that a double holds every dot
/// product of two cross products of differences without rounding: the answers must be right for
/// every input. A triangle may be without area: then it is a segment or a point, and its points
/// count as those of any triangle.
#pragma once

#include <contact/prelude.hpp>

#include <contact/shapes.hpp>

namespace exercise {

/// Whether one plane contains all six vertices.
///
/// @param first anywhere, perhaps without area
/// @param second the same
bool in_one_plane(const contact::Triangle<double>& first, const contact::Triangle<double>& second);

/// Whether two triangles in one plane have a point in common: inside, on an edge or at a vertex.
///
/// @param first perhaps without area; the vertices are in any order
/// @param second the same. One plane, in any direction, contains both triangles
bool meet_in_one_plane(const contact::Triangle<double>& first,
                       const contact::Triangle<double>& second);

}  // namespace exercise
