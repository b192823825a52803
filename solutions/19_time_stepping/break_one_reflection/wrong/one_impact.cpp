// misconception: break-one-impact-at-most
// caught by: a short step ends at the wrong position
// seen: not found
#include "break_one_reflection.hpp"

namespace exercise {

Step short_step() { return {0.5, 10, 0.1}; }

Step slow_point() { return {0.5, 1, 3.2}; }

Step two_impacts() { return {0.5, -1.7, 1}; }

}  // namespace exercise
