// misconception: break-outside-the-region
// caught by: the time is wrong by 10 % with k at most a half
// seen: https://github.com/Famous/famous/issues/257
//   a report on bounces that end too early has a restitution of 1
#include "break_the_cut_off.hpp"

namespace exercise {

Drop weak_bounces() { return {1, 0.9999}; }

Drop from_high_up() { return {1, 0.9999}; }

Drop by_a_minute() { return {1, 0.9999}; }

}  // namespace exercise
