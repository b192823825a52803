#include "break_one_reflection.hpp"

namespace exercise {

// The point would be at 4.21 m, in the fifth room.
Step short_step() { return {0.5, 100, 0.0371}; }

Step slow_point() { return {0.5, 1, 3.2}; }

// First the left wall, then the right one: the code tests them in the other order.
Step two_impacts() { return {0.5, -1.7, 1}; }

}  // namespace exercise
