/// @file
/// Exercise: friction only where it can matter.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A block that does not rotate, and touches a fixed surface.
struct Block {
  Eigen::Vector3d velocity;  ///< at the beginning of the step, m/s
  Eigen::Vector3d normal;    ///< of its surface, unit vector, towards the block
  double friction;           ///< coefficient of the block's material, 0 or more
  double surface_friction;   ///< coefficient of the surface's material, 0 or more
};

/// The result of a step.
struct Stepped {
  bool friction;                            ///< whether the scene runs with friction
  std::vector<Eigen::Vector3d> velocities;  ///< after the step, in the order of the blocks, m/s
};

/// Decides whether a scene of blocks needs friction, and takes one step of it.
///
/// There is one decision for the whole scene. Friction is left out only if it never changes the
/// motion of any block. For a block that holds if the pair of block and surface is smooth (a pair
/// has the smaller of its two coefficients), or if the block never slides, because neither its
/// velocity nor gravity has a tangential component. This component must be exactly zero, however
/// small it is. (Where it is zero in the test cases, the normal is along an axis.)
///
/// The step of a block: gravity acts for the time of the step. If the block then moves into its
/// surface, the surface removes the normal component of the velocity; there is no restitution. If
/// the scene runs with friction, the surface also reduces the slip, the tangential velocity: by at
/// most the pair's coefficient times the normal speed that it has just removed, and at most to
/// zero. A block that does not move into its surface is not changed by it.
///
/// @param blocks at least one
/// @param gravity m/s²
/// @param step s, greater than 0
Stepped step_blocks(const std::vector<Block>& blocks, const Eigen::Vector3d& gravity, double step);

}  // namespace exercise
