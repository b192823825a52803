// misconception: height-times-k
// caught by: one bounce takes the square of k
#include "drop_test.hpp"

namespace exercise {

double restitution(double drop, double rebound) { return std::sqrt(rebound / drop); }

double height_after(double drop, double k, int bounces) {
  for (; bounces > 0; --bounces) drop *= k;
  return drop;
}

}  // namespace exercise
