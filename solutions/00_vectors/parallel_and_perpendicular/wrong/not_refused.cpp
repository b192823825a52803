// misconception: zero-direction-not-refused
// caught by: a direction without length is refused
// seen: https://github.com/mrdoob/three.js/pull/18510 projections on a zero vector were NaN
#include "parallel_and_perpendicular.hpp"

namespace exercise {

double speed_along(const Eigen::Vector3d& velocity, const Eigen::Vector3d& direction) {
  return velocity.dot(direction) / direction.norm();
}

Components split(const Eigen::Vector3d& velocity, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d parallel = velocity.dot(direction) / direction.squaredNorm() * direction;
  return {parallel, velocity - parallel};
}

}  // namespace exercise
