// misconception: kahan-large-term
// caught by: small impulses beside a large one are not lost
// seen: https://github.com/SauersML/gam/issues/4306
#include "sum_of_impulses.hpp"

namespace exercise {

double total(const std::vector<double>& impulses) {
  double sum = 0;
  double carry = 0;
  for (const double x : impulses) {
    const double y = x - carry;
    const double next = sum + y;
    carry = (next - sum) - y;
    sum = next;
  }
  return sum;
}

}  // namespace exercise
