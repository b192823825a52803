/// @file
/// Exercise: when a ball that bounces without end comes to its end.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// When a dropped ball has come to rest, in s since it was let go. It bounces infinitely often
/// before.
///
/// @param drop from where it is let go, m, greater than 0
/// @param gravity m/s², greater than 0
/// @param k coefficient of restitution, greater than 0 and less than 1
double rest_time(double drop, double gravity, double k);

/// How often the ball has touched the floor by a time before it rests. An impact at that very time
/// counts.
///
/// @param drop, gravity, k as above
/// @param time s since it was let go, 0 or more and less than rest_time
int bounces_by(double drop, double gravity, double k, double time);

}  // namespace exercise
