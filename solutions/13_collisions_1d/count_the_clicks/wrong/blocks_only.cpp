// misconception: wall-not-counted
// caught by: mass ratios of one, two and three
// seen: https://t.xtos.us/v/yt/HEfHFsfGXjs says that another film counts the blocks alone
#include "count_the_clicks.hpp"

#include <cmath>

namespace exercise {

int clicks(double ratio) {
  double large = 1;
  double small = 0;
  int count = 0;
  while (large > small || small > 0) {
    if (large > small) {
      const double change = 2 * (large - small);
      large -= change / (ratio + 1);
      small += change * ratio / (ratio + 1);
      ++count;
    } else {
      small = -small;
    }
  }
  return count;
}

}  // namespace exercise
