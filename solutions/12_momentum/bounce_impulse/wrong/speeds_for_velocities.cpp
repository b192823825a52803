// misconception: speeds-for-velocities
// caught by: a bounce takes more than a stop
// seen: https://wikis.mit.edu/confluence/display/RELATE/Off+the+Wall
//   equal magnitudes "can easily lead to the conclusion that there has been no change"
#include "bounce_impulse.hpp"

namespace exercise {

Eigen::Vector3d impulse_of(double mass, const Eigen::Vector3d& before,
                           const Eigen::Vector3d& after) {
  return mass * (after.norm() - before.norm()) * before.normalized();
}

Eigen::Vector3d average_force(const Eigen::Vector3d& impulse, double duration) {
  return impulse / duration;
}

}  // namespace exercise
