// misconception: rounding-added-up
// caught by: small impulses beside a large one are not lost
#include "sum_of_impulses.hpp"

namespace exercise {

double total(const std::vector<double>& impulses) {
  double sum = 0;
  for (const double x : impulses) sum += x;
  return sum;
}

}  // namespace exercise
