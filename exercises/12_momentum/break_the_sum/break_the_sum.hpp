/// @file
/// Exercise: impulses whose sum in single precision is wrong.
#pragma once

#include <contact/prelude.hpp>

namespace exercise {

/// Three impulses, in N s, whose sum is not zero and of which given::sum_in_float returns zero.
/// Each is a whole number from -2^25 to 2^25.
std::vector<double> three_that_cancel();

/// At most ten impulses from -1 to 1 of which given::sum_in_float is wrong by more than half of the
/// right sum.
std::vector<double> none_above_one();

/// At most fifty impulses of which given::sum_in_float is wrong by more than 100 N s, although all
/// are positive. None is larger than 1e9.
std::vector<double> all_positive();

}  // namespace exercise
