/// @file
/// Exercise: a step of a ball between walls, with every impact in it.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// The front of a plane: all x with normal · x ≥ offset.
struct Wall {
  Eigen::Vector3d normal;  ///< unit vector, into the room
  double offset;           ///< m
};

/// A ball that moves in a straight line.
struct Ball {
  Eigen::Vector3d centre;    ///< m
  Eigen::Vector3d velocity;  ///< m/s
  double radius;             ///< m, 0 or more
  int impacts;               ///< so far
};

/// The ball one step later. It moves straight on until it touches the first wall that it
/// approaches, is reflected there, and uses up the rest of the step in the same way, as often as
/// need be. A reflection turns round the part of the velocity along the normal, times k, and leaves
/// the rest. An impact at the very end of the step belongs to it. A wall that the ball touches
/// without approaching it does nothing.
///
/// The test cases have no two walls that are met at one time, and no more than a hundred impacts in
/// a step.
/// @param ball at the start of the step, inside the room, perhaps touching walls
/// @param walls of the room
/// @param k coefficient of restitution, greater than 0 and at most 1
/// @param step s, greater than 0
Ball advance(const Ball& ball, const std::vector<Wall>& walls, double k, double step);

}  // namespace exercise
