#include "break_the_speed_limit.hpp"

namespace exercise {

// In a step it falls by 500/2 times the square of 0.0166, which is 0.069 m.
Step starts_at_rest() { return {0, 500, 0.1, 0, 0, 0.0166, 0.05}; }

// They approach with 4 m/s, by 0.066 m.
Step nothing_accelerates() { return {2, 0, 0.1, 0, 2, 0.0166, 0.05}; }

// The tip moves by 0.166 m.
Step centre_at_rest() { return {0, 0, 1, 10, 0, 0.0166, 0.05}; }

}  // namespace exercise
