// Neumaier's sum: the rounding error of each addition is computed exactly and added at the end.
#include "sum_of_impulses.hpp"

namespace exercise {

double total(const std::vector<double>& impulses) {
  double sum = 0;
  double lost = 0;
  for (const double x : impulses) {
    const double next = sum + x;
    lost += std::abs(sum) >= std::abs(x) ? (sum - next) + x : (x - next) + sum;
    sum = next;
  }
  return sum + lost;
}

}  // namespace exercise
