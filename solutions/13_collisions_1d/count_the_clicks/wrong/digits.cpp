// misconception: digits-of-pi
// caught by: equal blocks make three collisions
#include "count_the_clicks.hpp"

#include <cmath>

namespace exercise {

int clicks(double ratio) { return static_cast<int>(std::floor(M_PI * std::sqrt(ratio))); }

}  // namespace exercise
