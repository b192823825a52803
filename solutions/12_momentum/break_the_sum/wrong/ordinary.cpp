// misconception: break-sum-is-exact
// caught by: three whole numbers have the sum zero, and should not
// seen: https://github.com/tc39/test262/pull/4049
//   a test of an exact sum begins with 1 + 2 + 3, which every sum gets right
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
