// misconception: break-outside-the-region
// caught by: it is wrong after a small rotation
// seen: not found
#include "break_body_inertia.hpp"

namespace exercise {

Contact wrong_by_half() { return {{0.1, 10, 10}, 90, {0, 0, 1}, {1, 0, 0}}; }

Contact small_rotation() { return {{0.1, 10, 10}, 90, {0, 0, 1}, {1, 0, 0}}; }

Contact similar_moments() { return {{0.1, 0.2, 0.2}, 90, {0, 0, 1}, {1, 0, 0}}; }

}  // namespace exercise
