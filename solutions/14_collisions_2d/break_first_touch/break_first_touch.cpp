#include "break_first_touch.hpp"

#include "time_of_touch.hpp"

namespace exercise {

// They touched half a second ago: the smaller root is negative.
Approach overlapping() { return {{0.5, 0}, {-1, 0}, 1}; }

// The gap is 4e-16 m, and -b and the root agree in all digits but the last two.
Approach time_is_wrong() { return {{1 + 0x1p-51, 0}, {-1000, 0}, 1}; }

// The discriminant is 0.0025 beside numbers of 1e14, whose spacing is 0.016. It is rounded to zero,
// or to something negative at the first distance that is found.
Approach head_on() {
  double distance = 1e8;
  while (given::time_of_touch({distance, 0}, {-0.1, 0}, 0.5)) distance += 1;
  return {{distance, 0}, {-0.1, 0}, 0.5};
}

}  // namespace exercise
