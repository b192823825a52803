// misconception: break-within-rounding
// caught by: the sum of numbers up to 1 is wrong by half of itself
// seen: https://github.com/python/cpython/pull/29635 takes 0.30000000000000004 for a bug
#include "break_the_sum.hpp"

namespace exercise {

std::vector<double> three_that_cancel() { return {0x1p24, 1, -0x1p24}; }

std::vector<double> none_above_one() { return {0.1, 0.2, 0.3}; }

std::vector<double> all_positive() {
  std::vector<double> impulses(50, 30.0);
  impulses.front() = 1e9;
  return impulses;
}

}  // namespace exercise
