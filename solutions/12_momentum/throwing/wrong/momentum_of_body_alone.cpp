// misconception: momentum-of-body-alone
// caught by: rain slows a wagon and sand that runs out does not
#include "throwing.hpp"

namespace exercise {

double after_exchange(double mass, double velocity, double mass_change,
                      double /*matter_velocity*/) {
  return mass * velocity / (mass + mass_change);
}

double after_throws(double thrower, const std::vector<double>& stones, double velocity,
                    double relative) {
  // From the last stone backwards the whole mass grows by what is carried.
  double whole = thrower;
  double gained = 0;
  for (auto stone = stones.rbegin(); stone != stones.rend(); ++stone) {
    whole += *stone;
    gained -= relative * *stone / whole;
  }
  return velocity + gained;
}

}  // namespace exercise
