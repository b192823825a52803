// misconception: updated-too-early
// caught by: equal bodies exchange their velocities
// seen: https://github.com/hunar4321/particle-life/issues/18
//   later rules see what earlier ones have changed
#include "velocities_after.hpp"

namespace exercise {

After collide(const Body& first, const Body& second, double restitution) {
  if (!(first.mass > 0) || !(second.mass > 0))
    throw std::invalid_argument("a mass must be greater than 0");
  if (!(restitution >= 0 && restitution <= 1)) {
    throw std::invalid_argument("a coefficient of restitution must be from 0 to 1");
  }
  if (!(first.velocity > second.velocity)) return {first.velocity, second.velocity};
  double v1 = first.velocity;
  double v2 = second.velocity;
  const double mass = first.mass + second.mass;
  v1 = v1 - (1 + restitution) * (v1 - v2) * second.mass / mass;
  v2 = v2 + (1 + restitution) * (v1 - v2) * first.mass / mass;
  return {v1, v2};
}

}  // namespace exercise
