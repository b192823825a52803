#include "end_of_bounces.hpp"

namespace exercise {

double rest_time(double drop, double gravity, double k) {
  //? From h = gt²/2 follows the time of the first fall.
  //? gap: 2 * drop / gravity
  const double fall = std::sqrt(2 * drop / gravity);
  //? After the fall the flights last 2kt, 2k²t, and so on. The geometric series adds up to t(1 +
  //? k)/(1 − k).
  //? gap: (1 + k) / (1 - k)
  return fall * (1 + k) / (1 - k);
}

int bounces_by(double drop, double gravity, double k, double time) {
  //? The first impact is after one fall.
  const double fall = std::sqrt(2 * drop / gravity);
  //? No bounce has happened yet.
  int bounces = 0;
  //? The time of the next impact is kept.
  double impact = fall;
  //? The ball leaves with k times the speed, and goes up and down: 2k times the first fall.
  //? gap: 2 * k * fall
  double flight = 2 * k * fall;
  //? An impact exactly at the given time counts.
  //? gap: impact <= time
  while (impact <= time) {
    ++bounces;
    //? The next impact is one flight later, and the flight after that is k times as long.
    //? gap: flight *= k
    impact += flight;
    flight *= k;
  }
  //? All impacts up to the time are counted.
  return bounces;
}

}  // namespace exercise
