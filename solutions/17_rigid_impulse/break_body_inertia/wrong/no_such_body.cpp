// misconception: break-outside-the-region
// caught by: the value is wrong by more than a half
// seen: https://github.com/osrf/gazebo_models/issues/33 moments of 1.11, 100.11 and 1.01
#include "break_body_inertia.hpp"

namespace exercise {

Contact wrong_by_half() { return {{0.1, 0.1, 10}, 90, {0, 0, 1}, {1, 0, 0}}; }

Contact small_rotation() { return {{0.1, 10, 10}, 10, {0, 0, 1}, {1, 0, 0}}; }

Contact similar_moments() { return {{0.1, 0.2, 0.2}, 90, {0, 0, 1}, {1, 0, 0}}; }

}  // namespace exercise
