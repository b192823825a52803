/// @file
/// Exercise: points for which a parity is wrong.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

// The meshes are those of the given code. No point is on the surface of its mesh.

/// A point inside given::octahedron() that given::inside_by_parity takes for outside. Its
/// coordinates are whole numbers.
Eigen::Vector3d inside_the_octahedron();

/// A point to the left of given::house() that given::inside_by_parity takes for inside. Its
/// coordinates are whole numbers from -100 to 100, and x is negative.
Eigen::Vector3d left_of_the_house();

/// A point for which given::inside_by_parity is wrong about given::shard(), although the line
/// through the point along x meets no edge and no vertex. Its coordinates are any numbers from -100
/// to 100.
Eigen::Vector3d past_every_edge();

}  // namespace exercise
