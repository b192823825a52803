/// @file
/// Exercise: when a ball that bounces infinitely often comes to rest.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// The time after which a dropped ball is at rest, in s since the drop. Until then it bounces
/// infinitely often.
///
/// @param drop height of the drop, m, greater than 0
/// @param gravity m/s², greater than 0
/// @param k coefficient of restitution, greater than 0 and less than 1
double rest_time(double drop, double gravity, double k);

/// The number of impacts up to a time before the rest. An impact at exactly that time counts.
///
/// @param drop, gravity, k as above
/// @param time s since the drop, 0 or more and less than rest_time. Times so close to rest_time
/// that adding a flight no longer changes the sum are not tested.
int bounces_by(double drop, double gravity, double k, double time);

}  // namespace exercise
