// misconception: omega-not-squared
// caught by: one step from the turning point
// seen: https://github.com/RedPointyJackson/Brooglie/issues/4 in the potential of an oscillator
#include "verlet_step.hpp"

namespace exercise {

Swinging verlet_step(const Swinging& body, double angular_frequency, double step) {
  const double pull = angular_frequency;
  const double middle = body.velocity - pull * body.position * step / 2;
  const double position = body.position + middle * step;
  return {position, middle - pull * position * step / 2};
}

}  // namespace exercise
