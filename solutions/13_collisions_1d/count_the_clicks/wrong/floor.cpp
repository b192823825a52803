// misconception: floor-for-ceiling
// caught by: equal blocks make three collisions
// seen: https://augustge.com/animations/elastic-collisions
//   floor, where the inequality before it is strict
#include "count_the_clicks.hpp"

#include <cmath>

namespace exercise {

int clicks(double ratio) {
  return static_cast<int>(std::floor(M_PI / std::atan(std::sqrt(1 / ratio))));
}

}  // namespace exercise
