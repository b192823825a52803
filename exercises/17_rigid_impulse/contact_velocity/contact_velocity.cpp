#include "contact_velocity.hpp"

namespace exercise {

Eigen::Vector3d velocity_of_point(const Motion& body, const Eigen::Vector3d& /*point*/) {
  // Every point moves with the centre of mass. What does the rotation add?
  [[maybe_unused]] const Eigen::Vector3d with_the_centre = body.velocity;
  contact::todo();
}

Closing closing(const Motion& /*a*/, const Motion& /*b*/, const Eigen::Vector3d& /*point*/,
                const Eigen::Vector3d& /*normal*/) {
  contact::todo();
}

}  // namespace exercise
