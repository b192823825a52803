// misconception: left-for-right
// caught by: left is positive
// seen: https://github.com/PX4/PX4-Devguide/pull/289 a body's y axis that did not point to its left
#include "in_the_wagon.hpp"

namespace exercise {

Eigen::Vector2d position_in_wagon(const Wagon& wagon, const Eigen::Vector2d& position) {
  return velocity_in_wagon(wagon, position - wagon.position);
}

Eigen::Vector2d velocity_in_wagon(const Wagon& wagon, const Eigen::Vector2d& velocity) {
  const Eigen::Vector2d side(wagon.forward.y(), -wagon.forward.x());
  return {wagon.forward.dot(velocity), side.dot(velocity)};
}

Eigen::Vector2d position_in_world(const Wagon& wagon, const Eigen::Vector2d& position_in_wagon) {
  const Eigen::Vector2d side(wagon.forward.y(), -wagon.forward.x());
  return wagon.position + position_in_wagon.x() * wagon.forward + position_in_wagon.y() * side;
}

}  // namespace exercise
