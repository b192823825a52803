// misconception: friction-after-the-normal
// caught by: the slip stops and the end sticks
// seen: https://github.com/RandyGaul/ImpulseEngine/blob/359fecf88b11bccca8b3e2c400e2e5a0d527ea18/Manifold.cpp
#include "rod_on_floor.hpp"

namespace exercise {

Motion after_floor(const Body& body, const Eigen::Vector2d& point, double e, double friction) {
  const Eigen::Vector2d r = point - body.centre;
  const double k_tt = 1 / body.mass + r.y() * r.y() / body.inertia;
  const double k_tn = -r.x() * r.y() / body.inertia;
  const double k_nn = 1 / body.mass + r.x() * r.x() / body.inertia;
  const double slip = body.velocity.x() - body.angular_velocity * r.y();
  const double normal = body.velocity.y() + body.angular_velocity * r.x();
  if (!(normal < 0)) return {body.velocity, body.angular_velocity};

  const double up = -(1 + e) * normal / k_nn;
  const double stop = -(slip + k_tn * up) / k_tt;
  const double along = std::max(-friction * up, std::min(stop, friction * up));
  const Eigen::Vector2d impulse(along, up);
  return {body.velocity + impulse / body.mass,
          body.angular_velocity + (r.x() * up - r.y() * along) / body.inertia};
}

}  // namespace exercise
