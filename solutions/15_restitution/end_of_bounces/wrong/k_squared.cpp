// misconception: times-go-with-k-squared
// caught by: the ball rests after a finite time
// seen: https://github.com/codegenbot/seidr-solutions/blob/00162bcc8467acfdcd4ca59d3fe86ff4b2ad269a/bouncing-balls.cpp
//   flights shrink by the square of their factor
#include "end_of_bounces.hpp"

namespace exercise {

double rest_time(double drop, double gravity, double k) {
  const double fall = std::sqrt(2 * drop / gravity);
  return fall * (1 + k * k) / (1 - k * k);
}

int bounces_by(double drop, double gravity, double k, double time) {
  const double fall = std::sqrt(2 * drop / gravity);
  int bounces = 0;
  double impact = fall;
  double flight = 2 * k * k * fall;
  while (impact <= time && bounces < 10000) {
    ++bounces;
    impact += flight;
    flight *= k * k;
  }
  return bounces;
}

}  // namespace exercise
