// misconception: break-outside-the-region
// caught by: three whole numbers have the sum zero, and should not
// seen: https://github.com/rust-lang/rust/pull/10927 the example there is 1e20, 1 and −1e20
#include "break_the_sum.hpp"

namespace exercise {

std::vector<double> three_that_cancel() { return {1e16, 1, -1e16}; }

std::vector<double> none_above_one() { return {1, 1e-9, -1}; }

std::vector<double> all_positive() {
  std::vector<double> impulses(50, 30.0);
  impulses.front() = 1e9;
  return impulses;
}

}  // namespace exercise
