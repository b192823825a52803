#include "throwing.hpp"

namespace exercise {

double after_exchange(double mass, double velocity, double mass_change, double matter_velocity) {
  return velocity + (matter_velocity - velocity) * mass_change / (mass + mass_change);
}

double after_throws(double thrower, const std::vector<double>& stones, double velocity,
                    double relative) {
  // From the last stone backwards, the total mass grows by one stone each.
  double whole = thrower;
  double gained = 0;
  for (auto stone = stones.rbegin(); stone != stones.rend(); ++stone) {
    whole += *stone;
    gained -= relative * *stone / whole;
  }
  return velocity + gained;
}

}  // namespace exercise
