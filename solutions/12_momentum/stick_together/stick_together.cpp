#include "stick_together.hpp"

namespace exercise {

Eigen::Vector3d total_momentum(const std::vector<Body>& bodies) {
  //? The sum begins at zero, so no bodies have no momentum.
  Eigen::Vector3d sum(0, 0, 0);
  //? Momentum is mass times velocity, and adds up as a vector.
  //? gap: body.mass * body.velocity
  for (const Body& body : bodies) sum += body.mass * body.velocity;
  //? This is the total momentum.
  return sum;
}

Eigen::Vector3d velocity_together(const std::vector<Body>& bodies) {
  //? Without bodies there is nothing that could have a velocity.
  //? gap: bodies.empty()
  if (bodies.empty()) throw std::invalid_argument("there are no bodies");
  //? The common body has the mass of all of them.
  double mass = 0;
  //? A mass that is not positive, or not a number, is refused before it enters the sum.
  //? gap: !(body.mass > 0)
  for (const Body& body : bodies) {
    if (!(body.mass > 0)) throw std::invalid_argument("a mass must be greater than 0");
    mass += body.mass;
  }
  //? Momentum is conserved: the velocity is the whole momentum over the whole mass.
  //? gap: total_momentum(bodies) / mass
  return total_momentum(bodies) / mass;
}

}  // namespace exercise
