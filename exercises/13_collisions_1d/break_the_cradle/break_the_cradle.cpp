#include "break_the_cradle.hpp"

// The code to break. Your functions may call it, to search for an input on which it fails.
#include "one_pass.hpp"

namespace exercise {

std::vector<double> three_balls() { contact::todo(); }

std::vector<double> all_to_the_right() { contact::todo(); }

std::vector<double> one_pair_approaches() { contact::todo(); }

}  // namespace exercise
