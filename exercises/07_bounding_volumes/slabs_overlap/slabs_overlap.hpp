/// @file
/// Exercise: bodies between pairs of parallel planes, in directions that the user chooses.
///
/// A direction has any length, is not zero, and may be parallel or equal to another one. Its
/// coordinates are whole numbers from -1000 to 1000, those of positions and displacements from
/// -1000000 to 1000000, in m. A double holds all dot products of these without rounding, so each
/// answer must be exact.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A pair of planes perpendicular to a direction n: the points p with low <= n · p <= high are
/// between them. Both numbers are in m, times the length of n.
struct Slab {
  double low;
  double high;
};

/// The narrowest slab around a body for each direction, in the order of the directions.
///
/// @param directions at least one
/// @param vertices of the body, at least one
std::vector<Slab> slabs_of(const std::vector<Eigen::Vector3d>& directions,
                           const std::vector<Eigen::Vector3d>& vertices);

/// Whether the point is between each pair of planes. On a plane counts as between.
///
/// @param directions at least one
/// @param slabs one for each direction
/// @param point anywhere
bool between_each_pair(const std::vector<Eigen::Vector3d>& directions,
                       const std::vector<Slab>& slabs, const Eigen::Vector3d& point);

/// The index of the first direction in which two bodies are apart, or -1 if their slabs overlap in
/// every direction. Slabs that touch overlap. If they overlap in every direction, the bodies may
/// collide or not: the slabs do not tell.
///
/// @param first slabs of a body, at least one
/// @param second slabs of another body, for the same directions
int first_separating(const std::vector<Slab>& first, const std::vector<Slab>& second);

/// The slabs of the body after it has moved, without its vertices.
///
/// @param directions at least one
/// @param slabs of the body before, one for each direction
/// @param displacement of the body, which does not turn
std::vector<Slab> moved(const std::vector<Eigen::Vector3d>& directions,
                        const std::vector<Slab>& slabs, const Eigen::Vector3d& displacement);

}  // namespace exercise
