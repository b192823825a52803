#include "break_the_speed_limit.hpp"

// The code to break. Your functions may call it, to search for an input on which it fails.
#include "slow_enough.hpp"

namespace exercise {

Step starts_at_rest() { contact::todo(); }

Step nothing_accelerates() { contact::todo(); }

Step centre_at_rest() { contact::todo(); }

}  // namespace exercise
