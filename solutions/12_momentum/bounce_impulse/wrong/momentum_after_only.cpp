// misconception: momentum-after-only
// caught by: a stop takes all the momentum away
// seen: https://github.com/wreck02/wreck02/blob/44a826edbedc3f0bbdd52c0830820e578bda6da9/src/generators/forces/momentum.ts
//   a quiz's trap: mv instead of the change in momentum
#include "bounce_impulse.hpp"

namespace exercise {

Eigen::Vector3d impulse_of(double mass, const Eigen::Vector3d& /*before*/,
                           const Eigen::Vector3d& after) {
  return mass * after;
}

Eigen::Vector3d average_force(const Eigen::Vector3d& impulse, double duration) {
  return impulse / duration;
}

}  // namespace exercise
