// misconception: digits-of-pi
// caught by: mass ratios of one, two and three
// seen: https://github.com/DinantKistemaker/Bouncing-Pi/blob/6d85aaec/bounce_with_pi.m
//   floor(pi*sqrt(m)), there for large ratios
#include "count_the_clicks.hpp"

#include <cmath>

namespace exercise {

int clicks(double ratio) { return static_cast<int>(std::floor(M_PI * std::sqrt(ratio))); }

}  // namespace exercise
