// misconception: speeds-subtracted
// caught by: both move
// seen: https://physics.it.com/en/classical-mechanics/motion-in-a-straight-line/problems/motion-in-a-straight-line-challenge-two-trains-meeting
//   the most common error there: the difference of the speeds
#include "nothing_passes.hpp"

namespace exercise {

Proof prove(const Mover& a, const Mover& b, double step, double thickness) {
  const double speed = std::abs(a.speed - b.speed);
  const double acceleration = a.acceleration + b.acceleration;
  const double turning =
      a.angular_velocity * a.bounding_radius + b.angular_velocity * b.bounding_radius;
  const double displacement = (speed + acceleration * step / 2 + turning) * step;
  return {displacement, displacement <= thickness};
}

}  // namespace exercise
