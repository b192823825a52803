// misconception: euler-for-verlet
// caught by: one step from the turning point
// seen: https://github.com/TeamAtomECS/AtomECS/issues/8 its author thought that Verlet was in use
#include "verlet_step.hpp"

namespace exercise {

Swinging verlet_step(const Swinging& body, double angular_frequency, double step) {
  const double pull = angular_frequency * angular_frequency;
  const double velocity = body.velocity - pull * body.position * step;
  return {body.position + velocity * step, velocity};
}

}  // namespace exercise
