// misconception: break-outside-the-region
// caught by: a body whose centre is at rest may pass
// seen: https://github.com/dimforge/rapier/issues/303 the other body moves, and fast
#include "break_the_speed_limit.hpp"

namespace exercise {

Step starts_at_rest() { return {0, 500, 0.1, 0, 0, 0.0166, 0.05}; }

Step nothing_accelerates() { return {2, 0, 0.1, 0, 2, 0.0166, 0.05}; }

Step centre_at_rest() { return {0, 0, 1, 0, 10, 0.0166, 0.05}; }

}  // namespace exercise
