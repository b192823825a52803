// misconception: break-within-rounding
// caught by: the time is wrong by more than 1 %
// seen: https://github.com/libigl/libigl-python-bindings/issues/137
//   differences of 3e-17 are reported as a fault
#include "break_first_touch.hpp"

#include "time_of_touch.hpp"

namespace exercise {

Approach overlapping() { return {{0.5, 0}, {-1, 0}, 1}; }

Approach time_is_wrong() { return {{100, 0.1}, {-0.7, 0.001}, 1}; }

Approach head_on() {
  double distance = 1e8;
  while (given::time_of_touch({distance, 0}, {-0.1, 0}, 0.5)) distance += 1;
  return {{distance, 0}, {-0.1, 0}, 0.5};
}

}  // namespace exercise
