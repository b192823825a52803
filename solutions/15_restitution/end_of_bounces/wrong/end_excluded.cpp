// misconception: end-excluded
// caught by: bounces are counted from the first
#include "end_of_bounces.hpp"

namespace exercise {

double rest_time(double drop, double gravity, double k) {
  const double fall = std::sqrt(2 * drop / gravity);
  return fall * (1 + k) / (1 - k);
}

int bounces_by(double drop, double gravity, double k, double time) {
  const double fall = std::sqrt(2 * drop / gravity);
  int bounces = 0;
  double impact = fall;
  double flight = 2 * k * fall;
  while (impact < time) {
    ++bounces;
    impact += flight;
    flight *= k;
  }
  return bounces;
}

}  // namespace exercise
