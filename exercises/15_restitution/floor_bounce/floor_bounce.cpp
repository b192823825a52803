#include "floor_bounce.hpp"

namespace exercise {

Eigen::Vector3d after_bounce(const Eigen::Vector3d& velocity, const Eigen::Vector3d& normal,
                             double /*k*/) {
  // Normal velocity: negative if the body approaches the surface.
  [[maybe_unused]] const double along_normal = velocity.dot(normal);
  contact::todo();
}

}  // namespace exercise
