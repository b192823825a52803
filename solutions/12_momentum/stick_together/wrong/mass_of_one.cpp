// misconception: mass-of-one
// caught by: two players on a line move on with one velocity
// seen: https://www.physicsforums.com/threads/energy-conservation-of-a-car-collision.173914/
#include "stick_together.hpp"

namespace exercise {

Eigen::Vector3d total_momentum(const std::vector<Body>& bodies) {
  Eigen::Vector3d sum(0, 0, 0);
  for (const Body& body : bodies) sum += body.mass * body.velocity;
  return sum;
}

Eigen::Vector3d velocity_together(const std::vector<Body>& bodies) {
  if (bodies.empty()) throw std::invalid_argument("there are no bodies");
  for (const Body& body : bodies) {
    if (!(body.mass > 0)) throw std::invalid_argument("a mass must be greater than 0");
  }
  return total_momentum(bodies) / bodies.front().mass;
}

}  // namespace exercise
