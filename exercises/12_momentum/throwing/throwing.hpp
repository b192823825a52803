/// @file
/// Exercise: bodies that gain, lose or throw matter.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// The velocity of a body after matter has joined it or left it, in m/s. No external force acts,
/// and the motion is along one line.
///
/// @param mass before, kg, greater than 0
/// @param velocity before, m/s
/// @param mass_change kg: positive for matter that joins, negative for matter that leaves; mass +
/// mass_change is greater than 0
/// @param matter_velocity over the ground, m/s: before it joins, or after it has left
double after_exchange(double mass, double velocity, double mass_change, double matter_velocity);

/// The velocity of a thrower on ice after all stones have been thrown, one after the other, in m/s.
///
/// @param thrower mass of the thrower alone, kg, greater than 0
/// @param stones masses of the stones in the order in which they are thrown, kg, each greater than
/// 0; the thrower carries those that are still to be thrown
/// @param velocity of thrower and stones together before the first throw, m/s
/// @param relative velocity of a stone relative to the thrower just after it has been thrown, m/s
double after_throws(double thrower, const std::vector<double>& stones, double velocity,
                    double relative);

}  // namespace exercise
