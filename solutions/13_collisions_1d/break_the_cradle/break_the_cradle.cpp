#include "break_the_cradle.hpp"

namespace exercise {

// The impact has to travel to the left: its first contact is visited before it is pushed.
std::vector<double> three_balls() { return {0, 0, -5}; }

// The second ball passes its velocity on and gets that of the third. Then the first approaches it
// again, and their contact was visited before.
std::vector<double> all_to_the_right() { return {5, 5, 0, 0}; }

// The pair 2, 0 exchanges its velocities. Only then does the pair on its left approach.
std::vector<double> one_pair_approaches() { return {1, 2, 0}; }

}  // namespace exercise
