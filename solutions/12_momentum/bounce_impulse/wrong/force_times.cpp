// misconception: force-times-for-force-over
// caught by: a longer time makes a smaller force
// seen: not found
#include "bounce_impulse.hpp"

namespace exercise {

Eigen::Vector3d impulse_of(double mass, const Eigen::Vector3d& before,
                           const Eigen::Vector3d& after) {
  return mass * (after - before);
}

Eigen::Vector3d average_force(const Eigen::Vector3d& impulse, double duration) {
  return impulse * duration;
}

}  // namespace exercise
