// misconception: first-fall-left-out
// caught by: with k = 1/2 the ball rests after three times the first fall
#include "end_of_bounces.hpp"

namespace exercise {

double rest_time(double drop, double gravity, double k) {
  const double fall = std::sqrt(2 * drop / gravity);
  return 2 * fall * k / (1 - k);
}

int bounces_by(double drop, double gravity, double k, double time) {
  const double fall = std::sqrt(2 * drop / gravity);
  int bounces = 0;
  double impact = fall;
  double flight = 2 * k * fall;
  while (impact <= time) {
    ++bounces;
    impact += flight;
    flight *= k;
  }
  return bounces;
}

}  // namespace exercise
