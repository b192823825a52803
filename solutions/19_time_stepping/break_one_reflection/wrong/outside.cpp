// misconception: break-outside-the-region
// caught by: a slow point ends at the wrong position
// seen: https://github.com/JakeManfre/object-physics/issues/1
//   a circle whose centre is past the wall
#include "break_one_reflection.hpp"

namespace exercise {

Step short_step() { return {0.5, 100, 0.0371}; }

Step slow_point() { return {-3, 1, 1}; }

Step two_impacts() { return {0.5, -1.7, 1}; }

}  // namespace exercise
