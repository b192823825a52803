// misconception: rounding-added-up
// caught by: small impulses beside a large one are not lost
// seen: https://github.com/rust-lang/rust/pull/10927 the sum of 1e20, 1 and −1e20 was 0
#include "sum_of_impulses.hpp"

namespace exercise {

double total(const std::vector<double>& impulses) {
  double sum = 0;
  for (const double x : impulses) sum += x;
  return sum;
}

}  // namespace exercise
