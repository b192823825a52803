// misconception: break-cut-off-is-small
// caught by: the time is wrong by 10 % with k at most a half
// seen: https://github.com/godot-jolt/godot-jolt/issues/374
//   a ball that falls from low down does not bounce
#include "break_the_cut_off.hpp"

namespace exercise {

Drop weak_bounces() { return {0.0001, 0.5}; }

Drop from_high_up() { return {1, 0.9999}; }

Drop by_a_minute() { return {1, 0.9999}; }

}  // namespace exercise
