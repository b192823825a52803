#include "last_digits.hpp"

namespace exercise {

Eigen::Vector3d cross(const Eigen::Vector3d& /*u*/, const Eigen::Vector3d& /*v*/) {
  contact::todo();
}

}  // namespace exercise
