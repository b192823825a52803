#include "break_the_sum.hpp"

namespace exercise {

// The second is less than half of the spacing of floats at 2^24, or just half: it is lost.
std::vector<double> three_that_cancel() { return {0x1p24, 1, -0x1p24}; }

std::vector<double> none_above_one() { return {1, 1e-9, -1}; }

// Each impulse of 30 is less than half of the spacing at 1e9, which is 64.
std::vector<double> all_positive() {
  std::vector<double> impulses(50, 30.0);
  impulses.front() = 1e9;
  return impulses;
}

}  // namespace exercise
