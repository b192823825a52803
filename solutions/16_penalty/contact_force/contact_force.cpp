#include "contact_force.hpp"

namespace exercise {

double contact_force(double penetration, double approach, const Spring& spring) {
  //? Across a gap there is no force. A penetration of 0 is no gap.
  //? gap: penetration < 0
  if (penetration < 0) return 0;
  //? Spring and damper are in parallel, so their forces add, in approach and in separation.
  //? gap: spring.stiffness * penetration + spring.damping * approach
  const double force = spring.stiffness * penetration + spring.damping * approach;
  //? A negative sum would be a pull.
  //? gap: std::max(force, 0.0)
  return std::max(force, 0.0);
}

Eigen::Vector3d force_on_ball(const contact::Sphere<double>& ball, const Eigen::Vector3d& velocity,
                              const contact::Plane<double>& surface, const Spring& spring) {
  //? The deepest point of the ball is one radius below its centre.
  //? gap: ball.radius - distance
  const double distance = surface.normal.dot(ball.centre) - surface.offset;
  const double penetration = ball.radius - distance;
  //? The penetration changes with the velocity along the normal only, and decreases along it.
  //? gap: -surface.normal.dot(velocity)
  const double approach = -surface.normal.dot(velocity);
  //? The force pushes the ball out.
  //? gap: contact_force(penetration, approach, spring)
  return contact_force(penetration, approach, spring) * surface.normal;
}

}  // namespace exercise
