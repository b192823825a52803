// misconception: break-outside-the-region
// caught by: one of three balls moves
// seen: https://physics.stackexchange.com/questions/778791 then two balls from the left
#include "break_the_cradle.hpp"

namespace exercise {

std::vector<double> three_balls() { return {5, 5, 0}; }

std::vector<double> all_to_the_right() { return {5, 5, 0, 0}; }

std::vector<double> one_pair_approaches() { return {1, 2, 0}; }

}  // namespace exercise
