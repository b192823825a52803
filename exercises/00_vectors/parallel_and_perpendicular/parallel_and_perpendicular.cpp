#include "parallel_and_perpendicular.hpp"

namespace exercise {

double speed_along(const Eigen::Vector3d& velocity, const Eigen::Vector3d& direction) {
  const double length = direction.norm();
  if (length == 0) throw std::invalid_argument("direction: it has no length");

  // Complete: `velocity.dot(direction)` is this speed times the length of the direction.
  contact::todo();
}

Components split(const Eigen::Vector3d& velocity, const Eigen::Vector3d& direction) {
  if (direction.norm() == 0) throw std::invalid_argument("direction: it has no length");

  // Complete: a vector parallel to the direction, with the component speed_along, and the rest of
  // the velocity. Then end with `return {parallel, perpendicular};`.
  contact::todo();
}

}  // namespace exercise
