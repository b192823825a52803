// misconception: break-cradle-at-rest
// caught by: one of three balls moves
// seen: https://github.com/Famous/famous/pull/526 spheres that move apart, in a cradle too
#include "break_the_cradle.hpp"

namespace exercise {

std::vector<double> three_balls() { return {-5, 0, 0}; }

std::vector<double> all_to_the_right() { return {1, 2, 3}; }

std::vector<double> one_pair_approaches() { return {1, 2, 0}; }

}  // namespace exercise
