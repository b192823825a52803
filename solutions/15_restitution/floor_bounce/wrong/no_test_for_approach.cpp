// misconception: bounce-when-separating
// caught by: a body that moves away is left alone
// seen: https://github.com/JakeManfre/object-physics/issues/1 slow circles vibrate at a wall
#include "floor_bounce.hpp"

namespace exercise {

Eigen::Vector3d after_bounce(const Eigen::Vector3d& velocity, const Eigen::Vector3d& normal,
                             double k) {
  const double along_normal = velocity.dot(normal);
  return velocity - (1 + k) * along_normal * normal;
}

}  // namespace exercise
