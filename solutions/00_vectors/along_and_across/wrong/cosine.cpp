// misconception: cosine-for-speed
// caught by: a speed along a direction has a sign
#include "along_and_across.hpp"

namespace exercise {

double speed_along(const Eigen::Vector3d& velocity, const Eigen::Vector3d& direction) {
  if (direction.norm() == 0) throw std::invalid_argument("direction: it has no length");
  return velocity.dot(direction) / (velocity.norm() * direction.norm());
}

Parts split(const Eigen::Vector3d& velocity, const Eigen::Vector3d& direction) {
  if (direction.norm() == 0) throw std::invalid_argument("direction: it has no length");
  const Eigen::Vector3d along = velocity.dot(direction) / direction.squaredNorm() * direction;
  return {along, velocity - along};
}

}  // namespace exercise
