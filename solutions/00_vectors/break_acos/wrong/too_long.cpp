// misconception: break-outside-the-region
// caught by: the angle of whole numbers is wrong by more than 1 %
// seen: https://github.com/matrixorigin/matrixone/issues/29083
//   a report on cosines has vectors whose squares overflow
#include "break_acos.hpp"

namespace exercise {

Pair angle_is_no_number() { return {{0.1, 0.3, 0.1}, {0.3, 0.9, 0.3}}; }

Pair angle_is_lost() { return {{1e9, 1, 0}, {1e9, 0, 0}}; }

Pair large_angle() { return {{1e200, 0, 0}, {1e200, 1e200, 0}}; }

}  // namespace exercise
