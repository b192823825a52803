// misconception: break-outside-the-region
// caught by: a step with two impacts ends at the wrong position
// seen: https://github.com/BLAST-WarpX/warpx/issues/7089
//   several reflections in a step, however many
#include "break_one_reflection.hpp"

namespace exercise {

Step short_step() { return {0.5, 100, 0.0371}; }

Step slow_point() { return {0.5, 1, 3.2}; }

Step two_impacts() { return {0.5, 3, 1}; }

}  // namespace exercise
