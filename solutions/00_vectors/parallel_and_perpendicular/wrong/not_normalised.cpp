// misconception: direction-not-normalised
// caught by: the length of the direction does not count
// seen: https://github.com/juj/MathGeoLib/issues/73
//   a projection on a direction that is not normalised
#include "parallel_and_perpendicular.hpp"

namespace exercise {

double speed_along(const Eigen::Vector3d& velocity, const Eigen::Vector3d& direction) {
  if (direction.norm() == 0) throw std::invalid_argument("direction: it has no length");
  return velocity.dot(direction);
}

Components split(const Eigen::Vector3d& velocity, const Eigen::Vector3d& direction) {
  if (direction.norm() == 0) throw std::invalid_argument("direction: it has no length");
  const Eigen::Vector3d parallel = velocity.dot(direction) * direction;
  return {parallel, velocity - parallel};
}

}  // namespace exercise
