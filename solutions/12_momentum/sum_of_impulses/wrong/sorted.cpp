// misconception: sorting-for-accuracy
// caught by: small impulses beside a large one are not lost
// seen: https://stackoverflow.com/questions/6699066
//   sorting is proposed, and outwitted with negative numbers
#include "sum_of_impulses.hpp"

#include <algorithm>

namespace exercise {

double total(const std::vector<double>& impulses) {
  std::vector<double> sorted = impulses;
  std::sort(sorted.begin(), sorted.end(),
            [](double x, double y) { return std::abs(x) < std::abs(y); });
  double sum = 0;
  for (const double x : sorted) sum += x;
  return sum;
}

}  // namespace exercise
