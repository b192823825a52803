// misconception: break-step-is-refused
// caught by: a body at constant speed may pass
// seen: https://github.com/godotengine/godot/issues/6664
//   a fast body at constant speed passes a wall
#include "break_the_speed_limit.hpp"

namespace exercise {

Step starts_at_rest() { return {0, 500, 0.1, 0, 0, 0.0166, 0.05}; }

Step nothing_accelerates() { return {100, 0, 0.1, 0, 0, 0.0166, 0.05}; }

Step centre_at_rest() { return {0, 0, 1, 10, 0, 0.0166, 0.05}; }

}  // namespace exercise
