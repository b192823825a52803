/// @file
/// Exercise: the edge that separates two polygons, kept from one step to the next.
///
/// A polygon is the list of its vertices, counter-clockwise, at least three, no three of them on
/// one line. It is convex. Coordinates are whole numbers from -1000000 to 1000000, in m. A double
/// holds all dot and cross products of these without rounding, so each answer must be exact.
///
/// Edge i of a polygon begins at vertex i and ends at the next one; the last edge ends at vertex 0.
/// The polygon is to the left of each of its edges. An edge separates it from another polygon if
/// all vertices of the other one are to the right of the edge's line, and none is on the line.
/// Polygons without a common point are separated by an edge of one of them.
///
/// The edges of two polygons A and B with m and n vertices have numbers: 0 to m - 1 are the edges
/// of A, and m to m + n - 1 those of B.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// What one step tells about two polygons.
struct Answer {
  bool apart;   ///< they have no common point: polygons that touch are not apart
  int witness;  ///< the number of an edge that separates them, to be kept; -1 if none does
  int tested;   ///< how many edges were tested
};

/// Whether two polygons are apart, and by which edge.
///
/// The edge that was kept is tested first. If it does not separate the polygons, or none was kept,
/// the others are tested in the order of their numbers, until one separates them. No edge is tested
/// twice. The positions of all vertices may have changed since the edge was kept.
///
/// @param a, b polygons at this step
/// @param witness number of the edge that was kept; any number that no edge has means that none was
Answer test_pair(const std::vector<Eigen::Vector2d>& a, const std::vector<Eigen::Vector2d>& b,
                 int witness);

/// The number of the same edge if the polygons are given in the other order, B first. For a number
/// that no edge has, -1.
///
/// @param witness number of an edge of A and B, or any other number
/// @param edges_of_a, edges_of_b how many edges A and B have, at least three
int exchanged(int witness, int edges_of_a, int edges_of_b);

/// Two polygons of a list by their indices, and the edge that separates them.
struct Kept {
  int first;
  int second;
  int witness;  ///< with polygon `first` for A and polygon `second` for B
};

/// What one step tells about many polygons.
struct Step {
  std::vector<std::array<int, 2>> meeting;  ///< the pairs that are not apart
  std::vector<Kept> kept;                   ///< the pairs that are apart, for the next step
  int tested;                               ///< how many edges were tested for all pairs together
};

/// Tests pairs of polygons, each with the edge that was kept for this pair.
///
/// Both lists of the result have the pairs and their indices as `near` has them, in the same order.
/// Nothing is kept of a pair that meets, and of one that is not in `near`.
///
/// @param polygons at this step, whose numbers of vertices have not changed
/// @param near the pairs to test, no pair twice, not even in the other order
/// @param kept by the last step: no pair twice, in any order, and perhaps with the polygons of a
/// pair in the other order
Step test_pairs(const std::vector<std::vector<Eigen::Vector2d>>& polygons,
                const std::vector<std::array<int, 2>>& near, const std::vector<Kept>& kept);

}  // namespace exercise
