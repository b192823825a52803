// misconception: push-from-the-start-twice
// caught by: one step from the turning point
// seen: https://github.com/TeamAtomECS/AtomECS/pull/18 the velocity is made to use the new force
#include "verlet_step.hpp"

namespace exercise {

Swinging verlet_step(const Swinging& body, double angular_frequency, double step) {
  const double pull = angular_frequency * angular_frequency;
  const double middle = body.velocity - pull * body.position * step / 2;
  const double position = body.position + middle * step;
  return {position, middle - pull * body.position * step / 2};
}

}  // namespace exercise
