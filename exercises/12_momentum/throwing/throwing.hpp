/// @file
/// Exercise: bodies that gain matter, lose it, or throw it away.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// The velocity of a body after matter has joined it or left it, in m/s. No force acts from
/// outside, and the motion is along one line.
///
/// @param mass before, kg, greater than 0
/// @param velocity before, m/s
/// @param mass_change kg: positive for what joins, negative for what leaves; mass + mass_change is
/// greater than 0
/// @param matter_velocity over the ground, m/s: of what joins before it joins, of what leaves after
/// it has left
double after_exchange(double mass, double velocity, double mass_change, double matter_velocity);

/// The velocity of a thrower on ice who has thrown all stones, one after the other, in m/s.
///
/// @param thrower mass of the thrower alone, kg, greater than 0
/// @param stones masses of the stones in the order in which they are thrown, kg, each greater than
/// 0; the thrower carries those that are still to be thrown
/// @param velocity of thrower and stones together before the first throw, m/s
/// @param relative velocity of a stone that has just been thrown, as the thrower sees it then, m/s
double after_throws(double thrower, const std::vector<double>& stones, double velocity,
                    double relative);

}  // namespace exercise
