// misconception: place-not-subtracted
// caught by: ahead is ahead
#include "in_the_wagon.hpp"

namespace exercise {

Eigen::Vector2d place_in_wagon(const Wagon& wagon, const Eigen::Vector2d& place) {
  return velocity_in_wagon(wagon, place);
}

Eigen::Vector2d velocity_in_wagon(const Wagon& wagon, const Eigen::Vector2d& velocity) {
  const Eigen::Vector2d left(-wagon.forward.y(), wagon.forward.x());
  return {wagon.forward.dot(velocity), left.dot(velocity)};
}

Eigen::Vector2d place_in_world(const Wagon& wagon, const Eigen::Vector2d& place_in_wagon) {
  const Eigen::Vector2d left(-wagon.forward.y(), wagon.forward.x());
  return place_in_wagon.x() * wagon.forward + place_in_wagon.y() * left;
}

}  // namespace exercise
