// misconception: change-reversed
// caught by: a stop takes all the momentum away
// seen: https://www2.dbl.id/lock-code/20531236 J = 0.025 (4 − 0) for a ball that stops from 4 m/s
#include "bounce_impulse.hpp"

namespace exercise {

Eigen::Vector3d impulse_of(double mass, const Eigen::Vector3d& before,
                           const Eigen::Vector3d& after) {
  return mass * (before - after);
}

Eigen::Vector3d average_force(const Eigen::Vector3d& impulse, double duration) {
  return impulse / duration;
}

}  // namespace exercise
