// misconception: break-step-is-safe
// caught by: a body that starts at rest may pass
// seen: https://github.com/candirugame/candiru/issues/64 a fall of 2 m at 30 steps a second
#include "break_the_speed_limit.hpp"

namespace exercise {

Step starts_at_rest() { return {0, 9.81, 0.1, 0, 0, 0.0166, 0.05}; }

Step nothing_accelerates() { return {2, 0, 0.1, 0, 2, 0.0166, 0.05}; }

Step centre_at_rest() { return {0, 0, 1, 10, 0, 0.0166, 0.05}; }

}  // namespace exercise
