// misconception: place-subtracted-from-velocity
// caught by: a velocity has no position
// seen: https://github.com/ros/geometry2/issues/124 a translation is applied to a direction
#include "in_the_wagon.hpp"

namespace exercise {

Eigen::Vector2d position_in_wagon(const Wagon& wagon, const Eigen::Vector2d& position) {
  const Eigen::Vector2d left(-wagon.forward.y(), wagon.forward.x());
  const Eigen::Vector2d there = position - wagon.position;
  return {wagon.forward.dot(there), left.dot(there)};
}

Eigen::Vector2d velocity_in_wagon(const Wagon& wagon, const Eigen::Vector2d& velocity) {
  return position_in_wagon(wagon, velocity);
}

Eigen::Vector2d position_in_world(const Wagon& wagon, const Eigen::Vector2d& position_in_wagon) {
  const Eigen::Vector2d left(-wagon.forward.y(), wagon.forward.x());
  return wagon.position + position_in_wagon.x() * wagon.forward + position_in_wagon.y() * left;
}

}  // namespace exercise
