// misconception: break-cradle-from-the-left
// caught by: no ball moves to the left
// seen: https://physics.stackexchange.com/questions/778791 begins with one ball from the left
#include "break_the_cradle.hpp"

namespace exercise {

std::vector<double> three_balls() { return {0, 0, -5}; }

std::vector<double> all_to_the_right() { return {5, 0, 0, 0}; }

std::vector<double> one_pair_approaches() { return {1, 2, 0}; }

}  // namespace exercise
