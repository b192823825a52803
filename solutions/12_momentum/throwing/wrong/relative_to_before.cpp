// misconception: relative-to-before
// caught by: a throw pushes the thrower in the opposite direction
// seen: https://www.jiskha.com/questions/1064593
//   B: 16 + 2.15, the player's velocity before the throw
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
    whole -= stone;
    velocity -= relative * stone / whole;
  }
  return velocity;
}

}  // namespace exercise
