/// @file
/// Exercise: friction where it can matter, and nowhere else.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A block that does not turn, and touches a surface that does not move.
struct Block {
  Eigen::Vector3d velocity;  ///< at the beginning of the step, m/s
  Eigen::Vector3d normal;    ///< of its surface, unit vector, towards the block
  double friction;           ///< coefficient of the block's material, 0 or more
  double surface_friction;   ///< coefficient of the surface's material, 0 or more
};

/// What became of a scene.
struct Stepped {
  bool friction;                            ///< whether the scene runs with friction
  std::vector<Eigen::Vector3d> velocities;  ///< after the step, in the order of the blocks, m/s
};

/// Decides whether a scene of blocks needs friction, and takes one step of it.
///
/// The decision is one for the whole scene. Friction is left out only if it can change the motion
/// of no block, now or ever: because the pair of block and surface is smooth, and a pair has the
/// smaller of its two coefficients; or because the block never slides, since neither its velocity
/// nor gravity has any part along its surface. That part must be exactly zero: next to nothing is
/// something. (Where the test cases have zero, the normal is along an axis.)
///
/// The step of a block: gravity acts for the time of the step. If the block then moves into its
/// surface, the surface takes the part along the normal off the velocity; nothing bounces. If the
/// scene runs with friction, the surface also takes speed off the slip, the velocity along the
/// surface: at most the pair's coefficient times what it has just taken off along the normal, and
/// no more than there is. A block that does not move into its surface gets nothing from it.
///
/// @param blocks at least one
/// @param gravity m/s²
/// @param step s, greater than 0
Stepped step_blocks(const std::vector<Block>& blocks, const Eigen::Vector3d& gravity, double step);

}  // namespace exercise
