// misconception: zero-direction-not-refused
// caught by: a direction without length is refused
#include "along_and_across.hpp"

namespace exercise {

double speed_along(const Eigen::Vector3d& velocity, const Eigen::Vector3d& direction) {
  return velocity.dot(direction) / direction.norm();
}

Parts split(const Eigen::Vector3d& velocity, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d along = velocity.dot(direction) / direction.squaredNorm() * direction;
  return {along, velocity - along};
}

}  // namespace exercise
