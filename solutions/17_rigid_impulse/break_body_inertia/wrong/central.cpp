// misconception: break-no-torque
// caught by: it is wrong for similar moments
// seen: https://github.com/schteppe/cannon.js/issues/35 a kick at the centre, without rotation
#include "break_body_inertia.hpp"

namespace exercise {

Contact wrong_by_half() { return {{0.1, 10, 10}, 90, {0, 0, 1}, {1, 0, 0}}; }

Contact small_rotation() { return {{0.1, 10, 10}, 10, {0, 0, 1}, {1, 0, 0}}; }

Contact similar_moments() { return {{0.1, 0.2, 0.2}, 90, {1, 0, 0}, {1, 0, 0}}; }

}  // namespace exercise
