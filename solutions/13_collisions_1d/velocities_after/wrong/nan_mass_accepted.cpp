// misconception: mass-not-refused
// caught by: what is no mass or no coefficient is refused
#include "velocities_after.hpp"

namespace exercise {

After collide(const Body& first, const Body& second, double restitution) {
  if (first.mass <= 0 || second.mass <= 0)
    throw std::invalid_argument("a mass must be greater than 0");
  if (!(restitution >= 0 && restitution <= 1)) {
    throw std::invalid_argument("a coefficient of restitution must be from 0 to 1");
  }
  if (!(first.velocity > second.velocity)) return {first.velocity, second.velocity};
  const double change = (1 + restitution) * (first.velocity - second.velocity);
  const double mass = first.mass + second.mass;
  return {first.velocity - change * second.mass / mass,
          second.velocity + change * first.mass / mass};
}

}  // namespace exercise
