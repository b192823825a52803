#include "orientation_sign.hpp"

namespace exercise {

int orientation_sign(const Eigen::Vector2d& /*a*/, const Eigen::Vector2d& /*b*/,
                     const Eigen::Vector2d& /*c*/) {
  // In the plane, u × v has one coordinate only: u.x() * v.y() - u.y() * v.x().
  contact::todo();
}

}  // namespace exercise
