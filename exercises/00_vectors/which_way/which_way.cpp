#include "which_way.hpp"

namespace exercise {

int which_way(const Eigen::Vector2d& /*a*/, const Eigen::Vector2d& /*b*/,
              const Eigen::Vector2d& /*c*/) {
  // In the plane, u × v has one coordinate only: u.x() * v.y() - u.y() * v.x().
  contact::todo();
}

}  // namespace exercise
