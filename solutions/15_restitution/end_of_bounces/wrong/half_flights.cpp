// misconception: half-flights
// caught by: a ball that keeps half its speed rests after three falls' time
#include "end_of_bounces.hpp"

namespace exercise {

double rest_time(double drop, double gravity, double k) {
  const double fall = std::sqrt(2 * drop / gravity);
  return fall / (1 - k);
}

int bounces_by(double drop, double gravity, double k, double time) {
  const double fall = std::sqrt(2 * drop / gravity);
  int bounces = 0;
  double impact = fall;
  double flight = k * fall;
  while (impact <= time) {
    ++bounces;
    impact += flight;
    flight *= k;
  }
  return bounces;
}

}  // namespace exercise
