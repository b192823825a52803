// misconception: float-accumulator
// caught by: a few impulses add up
// seen: https://github.com/numpy/numpy/issues/5681
#include "sum_of_impulses.hpp"

namespace exercise {

double total(const std::vector<double>& impulses) {
  float sum = 0;
  for (const double x : impulses) sum += static_cast<float>(x);
  return sum;
}

}  // namespace exercise
