// misconception: one-of-one-plus-k
// caught by: a ball that falls vertically leaves with k times its speed
// seen: not found
#include "floor_bounce.hpp"

namespace exercise {

Eigen::Vector3d after_bounce(const Eigen::Vector3d& velocity, const Eigen::Vector3d& normal,
                             double k) {
  const double along_normal = velocity.dot(normal);
  if (!(along_normal < 0)) return velocity;
  return velocity - k * along_normal * normal;
}

}  // namespace exercise
