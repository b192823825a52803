// misconception: break-disc-is-near
// caught by: head-on discs are said to miss
// seen: https://github.com/ziotom78/pytracer/issues/22 says that nearer the test passes
#include "break_first_touch.hpp"

namespace exercise {

Approach overlapping() { return {{0.5, 0}, {-1, 0}, 1}; }

Approach time_is_wrong() { return {{1 + 0x1p-51, 0}, {-1000, 0}, 1}; }

Approach head_on() { return {{1000, 0}, {-0.1, 0}, 0.5}; }

}  // namespace exercise
