// misconception: one-impact-a-step
// caught by: a step with several impacts
// seen: https://github.com/BLAST-WarpX/warpx/issues/7089 lists it as a limitation
#include "whole_step.hpp"

namespace exercise {

Ball whole_step(const Ball& ball, double gravity, double k, double rest_speed, double step) {
  Ball now = ball;
  if (!now.resting) {
    const double speed = std::sqrt(now.velocity * now.velocity + 2 * gravity * now.height);
    const double until = now.velocity > 0 ? (now.velocity + speed) / gravity
                                          : 2 * now.height / (speed - now.velocity);
    if (until > step) {
      now.height = std::max(0.0, now.height + (now.velocity - gravity * step / 2) * step);
      now.velocity -= gravity * step;
      return now;
    }
    step -= until;
    now.height = 0;
    now.velocity = k * speed;
    ++now.bounces;
    if (now.velocity <= rest_speed) {
      now.velocity = 0;
      now.resting = true;
    } else {
      now.height = std::max(0.0, (now.velocity - gravity * step / 2) * step);
      now.velocity -= gravity * step;
    }
  }
  return now;
}

}  // namespace exercise
