// misconception: break-outside-the-region
// caught by: the time is wrong by 10 % from at least 1 m
// seen: https://github.com/avianphysics/avian/issues/200 a ball with k = 1 bounces once and stops
#include "break_the_cut_off.hpp"

namespace exercise {

Drop weak_bounces() { return {1e-7, 0.5}; }

Drop from_high_up() { return {1, 1}; }

Drop by_a_minute() { return {1, 0.9999}; }

}  // namespace exercise
