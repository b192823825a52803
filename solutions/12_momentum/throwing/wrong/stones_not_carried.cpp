// misconception: carried-mass-forgotten
// caught by: each throw starts from a smaller mass
// seen: not found
#include "throwing.hpp"

namespace exercise {

double after_exchange(double mass, double velocity, double mass_change, double matter_velocity) {
  return velocity + (matter_velocity - velocity) * mass_change / (mass + mass_change);
}

double after_throws(double thrower, const std::vector<double>& stones, double velocity,
                    double relative) {
  // As if the thrower carried only the stone that is thrown.
  for (const double stone : stones) velocity -= relative * stone / (thrower + stone);
  return velocity;
}

}  // namespace exercise
