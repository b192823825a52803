// misconception: break-outside-the-region
// caught by: the sum of positive numbers is wrong by 100
// seen: https://github.com/factor/factor/issues/948 its example has a large negative number
#include "break_the_sum.hpp"

namespace exercise {

std::vector<double> three_that_cancel() { return {0x1p24, 1, -0x1p24}; }

std::vector<double> none_above_one() { return {1, 1e-9, -1}; }

std::vector<double> all_positive() { return {1e9, 30, -1e9}; }

}  // namespace exercise
