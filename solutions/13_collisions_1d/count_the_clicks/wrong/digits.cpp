// misconception: digits-of-pi
// caught by: other mass ratios
#include "count_the_clicks.hpp"

#include <cmath>

namespace exercise {

int clicks(double ratio) { return static_cast<int>(std::floor(M_PI * std::sqrt(ratio))); }

}  // namespace exercise
