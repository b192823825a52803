#include "contact_velocity.hpp"

namespace exercise {

Eigen::Vector3d velocity_of_point(const Motion& body, const Eigen::Vector3d& point) {
  const Eigen::Vector3d lever_arm = point - body.centre;
  return body.velocity + body.angular_velocity.cross(lever_arm);
}

Closing closing(const Motion& a, const Motion& b, const Eigen::Vector3d& point,
                const Eigen::Vector3d& normal) {
  const Eigen::Vector3d relative = velocity_of_point(a, point) - velocity_of_point(b, point);
  const double speed = normal.dot(relative);
  if (speed < 0) return Closing::approaching;
  if (speed > 0) return Closing::separating;
  return Closing::touching;
}

}  // namespace exercise
