// misconception: break-acos-at-most-one
// caught by: the angle of short vectors is NaN
// seen: https://github.com/biojava/biojava/issues/275
//   says that parallel vectors give NaN; not all of them do
#include "break_acos.hpp"

namespace exercise {

Pair angle_is_no_number() { return {{1, 0, 0}, {1, 0, 0}}; }

Pair angle_is_lost() { return {{1e6, 1e6 - 1, 0}, {1e6 - 1, 1e6 - 2, 0}}; }

Pair large_angle() { return {{1e200, 0, 0}, {1e200, 1e200, 0}}; }

}  // namespace exercise
