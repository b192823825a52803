/// @file
/// Exercise: whether a ball that bounces can be followed from impact to impact.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A ball that is let go over a floor.
struct Ball {
  double drop;     ///< how high over the floor, m, greater than 0
  double gravity;  ///< m/s², greater than 0
  double k;        ///< coefficient of restitution, 0 to 1
};

/// How the ball is followed through a scene.
struct Run {
  bool events;   ///< from impact to impact; if not, step by step
  int impacts;   ///< how many are followed; step by step 0
  double error;  ///< how high the highest hop is that is left out, m; 0 if none is
  double early;  ///< how much earlier the ball rests than it would, s; 0 if no hop is left out
};

/// The plan for a ball from its start, at time 0, until the end of the scene.
///
/// From impact to impact, hops that rise higher than the tolerance are followed. With the first
/// that does not, the ball is laid to rest at the impact that would begin it, and all hops from
/// there on are left out. Impacts until the end of the scene are followed, one at the very end and
/// the one that lays the ball to rest included. If the scene ends before the ball is laid to rest,
/// nothing is left out.
///
/// If that takes more impacts than the budget, the ball goes step by step.
///
/// In the test cases no impact and no height is within rounding of where the answer changes, unless
/// it can be computed exactly.
/// @param ball to follow
/// @param duration of the scene, s, greater than 0
/// @param tolerance of a place, m, greater than 0 and less than the drop
/// @param budget impacts that are affordable, 0 or more
Run plan_run(const Ball& ball, double duration, double tolerance, int budget);

}  // namespace exercise
