// misconception: relative-for-ground
// caught by: a throw pushes the thrower in the opposite direction
// seen: https://brainmass.com/physics/conservation-of-momentum/the-conservation-of-momentum-4407
//   case a: M V = N m u, where u is relative to the car
#include "throwing.hpp"

namespace exercise {

double after_exchange(double mass, double velocity, double mass_change, double matter_velocity) {
  return velocity + (matter_velocity - velocity) * mass_change / (mass + mass_change);
}

double after_throws(double thrower, const std::vector<double>& stones, double velocity,
                    double relative) {
  double whole = thrower;
  for (const double stone : stones) whole += stone;
  for (const double stone : stones) {
    velocity = (whole * velocity - stone * relative) / (whole - stone);
    whole -= stone;
  }
  return velocity;
}

}  // namespace exercise
