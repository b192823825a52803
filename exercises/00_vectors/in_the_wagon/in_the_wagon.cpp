#include "in_the_wagon.hpp"

namespace exercise {

Eigen::Vector2d position_in_wagon(const Wagon& /*wagon*/, const Eigen::Vector2d& /*position*/) {
  contact::todo();
}

Eigen::Vector2d velocity_in_wagon(const Wagon& /*wagon*/, const Eigen::Vector2d& /*velocity*/) {
  contact::todo();
}

Eigen::Vector2d position_in_world(const Wagon& /*wagon*/,
                                  const Eigen::Vector2d& /*position_in_wagon*/) {
  contact::todo();
}

}  // namespace exercise
