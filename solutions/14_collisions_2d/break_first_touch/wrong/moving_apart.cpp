// misconception: break-outside-the-region
// caught by: discs that overlap and approach touch now
// seen: https://github.com/HaliteChallenge/Halite-II/pull/199
//   ships that move apart: a negative time
#include "break_first_touch.hpp"

#include "time_of_touch.hpp"

namespace exercise {

Approach overlapping() { return {{0.5, 0}, {1, 0}, 1}; }

Approach time_is_wrong() { return {{1 + 0x1p-51, 0}, {-1000, 0}, 1}; }

Approach head_on() {
  double distance = 1e8;
  while (given::time_of_touch({distance, 0}, {-0.1, 0}, 0.5)) distance += 1;
  return {{distance, 0}, {-0.1, 0}, 0.5};
}

}  // namespace exercise
