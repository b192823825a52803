// misconception: count-by-rounded-formula
// caught by: close cases
// seen: https://codegolf.stackexchange.com/questions/198615/elastic-collisions-between-blocks
//   an answer with the rounded formula
#include "count_the_clicks.hpp"

#include <cmath>

namespace exercise {

int clicks(double ratio) {
  return static_cast<int>(std::ceil(M_PI / std::atan(std::sqrt(1 / ratio)))) - 1;
}

}  // namespace exercise
