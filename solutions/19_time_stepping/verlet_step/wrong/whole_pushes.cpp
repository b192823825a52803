// misconception: whole-push-twice
// caught by: one step from the turning point
// seen: https://github.com/headmyshoulder/odeint-v2/issues/150
//   a whole dt² in the position for a half
#include "verlet_step.hpp"

namespace exercise {

Swinging verlet_step(const Swinging& body, double angular_frequency, double step) {
  const double pull = angular_frequency * angular_frequency;
  const double middle = body.velocity - pull * body.position * step;
  const double position = body.position + middle * step;
  return {position, middle - pull * position * step};
}

}  // namespace exercise
