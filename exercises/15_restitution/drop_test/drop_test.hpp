/// @file
/// Exercise: the coefficient of restitution from heights, and heights from it.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// The coefficient of restitution of a ball that is dropped from one height and rises to another.
///
/// @param drop m, greater than 0
/// @param rebound m, from 0 to drop
double restitution(double drop, double rebound);

/// The height to which a ball rises after a number of bounces, in m.
///
/// @param drop height of the drop, m, greater than 0
/// @param k coefficient of restitution, 0 to 1
/// @param bounces 0 or more; for 0 the result is the drop itself
double height_after(double drop, double k, int bounces);

}  // namespace exercise
