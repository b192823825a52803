#include "velocities_after.hpp"

namespace exercise {

After collide(const Body& first, const Body& second, double restitution) {
  //? The negated comparison also refuses NaN.
  //? gap: !(second.mass > 0)
  if (!(first.mass > 0) || !(second.mass > 0))
    throw std::invalid_argument("a mass must be greater than 0");
  //? Outside 0 to 1 a collision would create energy, or the bodies would pass through each other.
  //? gap: restitution >= 0 && restitution <= 1
  if (!(restitution >= 0 && restitution <= 1)) {
    throw std::invalid_argument("a coefficient of restitution must be from 0 to 1");
  }
  //? The first body is on the left; unless it is faster, the two do not approach and nothing
  //? changes.
  //? gap: first.velocity > second.velocity
  if (!(first.velocity > second.velocity)) return {first.velocity, second.velocity};
  //? Newton: the relative velocity becomes −k times itself, so it changes by 1 + k times itself.
  //? gap: (1 + restitution)
  const double change = (1 + restitution) * (first.velocity - second.velocity);
  //? The change is shared, so the shares are fractions of the whole mass.
  const double mass = first.mass + second.mass;
  //? The impulses are equal and opposite; the lighter body changes its velocity more, hence each
  //? has the other's mass.
  //? gap: change * second.mass / mass
  //? gap: change * first.mass / mass
  return {first.velocity - change * second.mass / mass,
          second.velocity + change * first.mass / mass};
}

}  // namespace exercise
