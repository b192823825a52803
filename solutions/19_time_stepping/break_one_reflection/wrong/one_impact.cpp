// misconception: break-one-impact-at-most
// caught by: a short step ends at the wrong position
// seen: https://github.com/Farama-Foundation/PettingZoo/pull/1453
//   one reflection is tested with steps of 40 in an area of 300
#include "break_one_reflection.hpp"

namespace exercise {

Step short_step() { return {0.5, 10, 0.1}; }

Step slow_point() { return {0.5, 1, 3.2}; }

Step two_impacts() { return {0.5, -1.7, 1}; }

}  // namespace exercise
