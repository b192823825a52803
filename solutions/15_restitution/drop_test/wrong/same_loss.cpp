// misconception: same-loss-each-bounce
// caught by: each bounce starts from the height before
#include "drop_test.hpp"

namespace exercise {

double restitution(double drop, double rebound) { return std::sqrt(rebound / drop); }

double height_after(double drop, double k, int bounces) {
  const double lost = (1 - k * k) * drop;
  return drop - lost * bounces;
}

}  // namespace exercise
