/// @file
/// Exercise: steps with more impacts than the code expects.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// A step of a point between walls at 0 m and 1 m.
struct Step {
  double position;  ///< m, from 0 to 1
  double velocity;  ///< m/s
  double duration;  ///< of the step, s, greater than 0
};

/// A step of at most 0.1 s after which given::reflect_once is wrong by more than 0.01 m. Like all
/// steps here, it is at most 1000 s long and no faster than 1000 m/s.
Step short_step();

/// A step of a point that moves with at most 1 m/s after which given::reflect_once is wrong by more
/// than 0.01 m.
Step slow_point();

/// A step with at most two impacts after which given::reflect_once is wrong by more than 0.01 m.
Step two_impacts();

}  // namespace exercise
