// misconception: speed-along-without-sign
// caught by: a speed along a direction has a sign
// seen: https://github.com/tawnkramer/gym-donkeycar/issues/43
//   the speed is positive although the car reverses
#include "parallel_and_perpendicular.hpp"

namespace exercise {

double speed_along(const Eigen::Vector3d& velocity, const Eigen::Vector3d& direction) {
  if (direction.norm() == 0) throw std::invalid_argument("direction: it has no length");
  return std::abs(velocity.dot(direction)) / direction.norm();
}

Components split(const Eigen::Vector3d& velocity, const Eigen::Vector3d& direction) {
  if (direction.norm() == 0) throw std::invalid_argument("direction: it has no length");
  const Eigen::Vector3d parallel =
      std::abs(velocity.dot(direction)) / direction.squaredNorm() * direction;
  return {parallel, velocity - parallel};
}

}  // namespace exercise
