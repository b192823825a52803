// misconception: restitution-of-each-body
// caught by: equal bodies exchange their velocities
// seen: https://github.com/kaplayjs/kaplay/issues/958 each as if the other did not move
#include "velocities_after.hpp"

namespace exercise {

After collide(const Body& first, const Body& second, double restitution) {
  if (!(first.mass > 0) || !(second.mass > 0))
    throw std::invalid_argument("a mass must be greater than 0");
  if (!(restitution >= 0 && restitution <= 1)) {
    throw std::invalid_argument("a coefficient of restitution must be from 0 to 1");
  }
  if (!(first.velocity > second.velocity)) return {first.velocity, second.velocity};
  return {-restitution * first.velocity, -restitution * second.velocity};
}

}  // namespace exercise
