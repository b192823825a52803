// misconception: floor-for-ceiling
// caught by: mass ratios of one, two and three
// seen: https://tizarne.com/youtube/video/brU5yLm9DZM
//   3Blue1Brown's own correction: a ceiling minus 1 where the film had a floor
#include "count_the_clicks.hpp"

#include <cmath>

namespace exercise {

int clicks(double ratio) {
  return static_cast<int>(std::floor(M_PI / std::atan(std::sqrt(1 / ratio))));
}

}  // namespace exercise
