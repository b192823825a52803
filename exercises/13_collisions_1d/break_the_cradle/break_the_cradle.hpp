/// @file
/// Exercise: a row of balls for which one pass is not enough.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// The velocities of three balls in a row, in m/s, of which given::one_pass is wrong. Only one of
/// them moves.
///
/// Like those of the other functions: from left to right, each a whole number from -10 to 10; to
/// the right is positive.
std::vector<double> three_balls();

/// The velocities of two to eight balls of which given::one_pass is wrong, although none moves to
/// the left.
std::vector<double> all_to_the_right();

/// The velocities of two to eight balls of which given::one_pass is wrong, although only one pair
/// of neighbours approaches.
std::vector<double> one_pair_approaches();

}  // namespace exercise
