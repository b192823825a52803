// misconception: break-sum-is-exact
// caught by: three whole numbers have the sum zero, and should not
// seen: not found
#include "break_the_sum.hpp"

namespace exercise {

std::vector<double> three_that_cancel() { return {1000, 1, -1000}; }

std::vector<double> none_above_one() { return {1, 1e-9, -1}; }

std::vector<double> all_positive() {
  std::vector<double> impulses(50, 30.0);
  impulses.front() = 1e9;
  return impulses;
}

}  // namespace exercise
