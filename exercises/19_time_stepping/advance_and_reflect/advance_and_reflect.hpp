/// @file
/// Exercise: one step of a ball between walls, with all its impacts.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A half-space in which the ball may be: all x with normal · x ≥ offset.
struct Wall {
  Eigen::Vector3d normal;  ///< unit vector, into the room
  double offset;           ///< m
};

/// A ball that moves in straight lines.
struct Ball {
  Eigen::Vector3d centre;    ///< m
  Eigen::Vector3d velocity;  ///< m/s
  double radius;             ///< m, 0 or more
  int impacts;               ///< so far
};

/// The ball one step later. It moves in a straight line to the first wall that it hits, is
/// reflected there, and uses up the rest of the step in the same way, however many impacts there
/// are. A reflection multiplies the normal component of the velocity by −k and does not change the
/// tangential component. An impact exactly at the end of the step counts. A wall that the ball
/// touches without approaching it has no effect.
///
/// In the test cases no two walls are hit at the same time, and a step has at most a hundred
/// impacts.
/// @param ball at the start of the step, inside the room, perhaps touching walls
/// @param walls of the room
/// @param k coefficient of restitution, greater than 0 and at most 1
/// @param step s, greater than 0
Ball advance(const Ball& ball, const std::vector<Wall>& walls, double k, double step);

}  // namespace exercise
