// misconception: bounce-reverses-all
// caught by: the tangential component is unchanged
// seen: https://github.com/NTaylorMullen/ShootR/issues/23 a ship bounces directly back
#include "floor_bounce.hpp"

namespace exercise {

Eigen::Vector3d after_bounce(const Eigen::Vector3d& velocity, const Eigen::Vector3d& normal,
                             double k) {
  const double along_normal = velocity.dot(normal);
  if (!(along_normal < 0)) return velocity;
  return -k * velocity;
}

}  // namespace exercise
