// misconception: break-cut-off-is-small
// caught by: the time is wrong by 10 % from at least 1 m
// seen: https://github.com/dimforge/rapier/pull/114
//   shows a ball with k = 0.9 that a threshold stops
#include "break_the_cut_off.hpp"

namespace exercise {

Drop weak_bounces() { return {1e-7, 0.5}; }

Drop from_high_up() { return {1, 0.8}; }

Drop by_a_minute() { return {1, 0.9999}; }

}  // namespace exercise
