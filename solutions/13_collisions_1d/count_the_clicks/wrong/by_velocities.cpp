// misconception: count-by-rounded-velocities
// caught by: close cases
// seen: https://possiblywrong.wordpress.com/2021/06/30/counting-collisions/
#include "count_the_clicks.hpp"

#include <cmath>

namespace exercise {

int clicks(double ratio) {
  double large = 1;
  double small = 0;
  for (int count = 0;; ++count) {
    if (large > small) {
      const double change = 2 * (large - small);
      large -= change / (ratio + 1);
      small += change * ratio / (ratio + 1);
    } else if (small > 0) {
      small = -small;
    } else {
      return count;
    }
  }
}

}  // namespace exercise
