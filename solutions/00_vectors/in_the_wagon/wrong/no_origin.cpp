// misconception: place-not-subtracted
// caught by: ahead is ahead
// seen: https://github.com/groops-dev/groops/issues/59
//   a position is rotated into a local frame and not moved
#include "in_the_wagon.hpp"

namespace exercise {

Eigen::Vector2d position_in_wagon(const Wagon& wagon, const Eigen::Vector2d& position) {
  return velocity_in_wagon(wagon, position);
}

Eigen::Vector2d velocity_in_wagon(const Wagon& wagon, const Eigen::Vector2d& velocity) {
  const Eigen::Vector2d left(-wagon.forward.y(), wagon.forward.x());
  return {wagon.forward.dot(velocity), left.dot(velocity)};
}

Eigen::Vector2d position_in_world(const Wagon& wagon, const Eigen::Vector2d& position_in_wagon) {
  const Eigen::Vector2d left(-wagon.forward.y(), wagon.forward.x());
  return position_in_wagon.x() * wagon.forward + position_in_wagon.y() * left;
}

}  // namespace exercise
