// misconception: mean-of-velocities
// caught by: two players on a line move on with one velocity
// seen: https://github.com/wreck02/wreck02/blob/44a826edbedc3f0bbdd52c0830820e578bda6da9/src/generators/forces/momentum.ts
//   a quiz's trap: averaged the speeds without weighting by mass
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
  Eigen::Vector3d sum(0, 0, 0);
  for (const Body& body : bodies) sum += body.velocity;
  return sum / static_cast<double>(bodies.size());
}

}  // namespace exercise
