#include "break_the_cut_off.hpp"

namespace exercise {

// The fall takes 0.14 ms, so the first flight is below the millisecond already.
Drop weak_bounces() { return {1e-7, 0.5}; }

// After a thousand flights k to the power n is still 0.90: most of the time is to come.
Drop from_high_up() { return {1, 0.9999}; }

Drop by_a_minute() { return {1, 0.9999}; }

}  // namespace exercise
