// misconception: mass-not-refused
// caught by: what is no mass is refused
#include "stick_together.hpp"

namespace exercise {

Eigen::Vector3d total_momentum(const std::vector<Body>& bodies) {
  Eigen::Vector3d sum(0, 0, 0);
  for (const Body& body : bodies) sum += body.mass * body.velocity;
  return sum;
}

Eigen::Vector3d velocity_together(const std::vector<Body>& bodies) {
  if (bodies.empty()) throw std::invalid_argument("there are no bodies");
  double mass = 0;
  for (const Body& body : bodies) {
    mass += body.mass;
  }
  return total_momentum(bodies) / mass;
}

}  // namespace exercise
