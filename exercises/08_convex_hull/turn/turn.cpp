#include "turn.hpp"

namespace exercise {

int turn(const Eigen::Vector2d& /*a*/, const Eigen::Vector2d& /*b*/, const Eigen::Vector2d& /*c*/) {
  // What is the sign of the cross product of two of the edges?
  contact::todo();
}

}  // namespace exercise
