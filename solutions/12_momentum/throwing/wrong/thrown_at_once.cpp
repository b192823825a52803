// misconception: thrown-at-once
// caught by: each throw starts from a smaller mass
// seen: https://brainmass.com/physics/conservation-of-momentum/conservation-momentum-problem-17397
//   an answer throws two bricks as one
#include "throwing.hpp"

namespace exercise {

double after_exchange(double mass, double velocity, double mass_change, double matter_velocity) {
  return velocity + (matter_velocity - velocity) * mass_change / (mass + mass_change);
}

double after_throws(double thrower, const std::vector<double>& stones, double velocity,
                    double relative) {
  double thrown = 0;
  for (const double stone : stones) thrown += stone;
  return velocity - relative * thrown / (thrower + thrown);
}

}  // namespace exercise
