#include "orientation.hpp"

namespace exercise {

int orientation(const Eigen::Vector2d& /*a*/, const Eigen::Vector2d& /*b*/,
                const Eigen::Vector2d& /*c*/) {
  // What is the sign of the cross product of two of the edges?
  contact::todo();
}

}  // namespace exercise
