// misconception: break-outside-the-region
// caught by: only one pair approaches
// seen: not found
#include "break_the_cradle.hpp"

namespace exercise {

std::vector<double> three_balls() { return {0, 0, -5}; }

std::vector<double> all_to_the_right() { return {5, 5, 0, 0}; }

std::vector<double> one_pair_approaches() { return {0.25, 0.5, 0}; }

}  // namespace exercise
