/// @file
/// Exercise: whether a ball that bounces can be followed from impact to impact.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A ball that is released above a floor.
struct Ball {
  double drop;     ///< height above the floor, m, greater than 0
  double gravity;  ///< m/s², greater than 0
  double k;        ///< coefficient of restitution, 0 to 1
};

/// How the ball is followed through a scene.
struct Run {
  bool events;   ///< from impact to impact; if not, step by step
  int impacts;   ///< number of impacts followed; 0 step by step
  double error;  ///< height of the highest bounce that is left out, m; 0 if none is
  double early;  ///< how much too early the ball rests, s; 0 if no bounce is left out
};

/// The plan for a ball from its start, at time 0, until the end of the scene.
///
/// From impact to impact, bounces that rise higher than the tolerance are followed. At the impact
/// that would begin the first lower bounce, the ball is set to rest, and this bounce and all later
/// ones are left out. All impacts until the end of the scene are counted, including one exactly at
/// the end, and including the one that sets the ball to rest. If the scene ends before the ball is
/// set to rest, nothing is left out.
///
/// If that takes more impacts than the budget, the ball goes step by step.
///
/// In the test cases no impact time and no height is within rounding of a value where the answer
/// changes, unless it can be computed exactly.
/// @param ball to follow
/// @param duration of the scene, s, greater than 0
/// @param tolerance of a position, m, greater than 0 and less than the drop
/// @param budget number of impacts allowed, 0 or more
Run plan_run(const Ball& ball, double duration, double tolerance, int budget);

}  // namespace exercise
