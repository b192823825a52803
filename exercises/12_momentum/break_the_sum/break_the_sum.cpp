#include "break_the_sum.hpp"

// The code to break. Your functions may call it, to search for an input on which it fails.
#include "sum_in_float.hpp"

namespace exercise {

std::vector<double> three_that_cancel() { contact::todo(); }

std::vector<double> none_above_one() { contact::todo(); }

std::vector<double> all_positive() { contact::todo(); }

}  // namespace exercise
