// misconception: rest-by-incoming-speed
// caught by: the ball comes to rest
#include "whole_step.hpp"

namespace exercise {

Ball whole_step(const Ball& ball, double gravity, double k, double rest_speed, double step) {
  Ball now = ball;
  while (!now.resting) {
    const double speed = std::sqrt(now.velocity * now.velocity + 2 * gravity * now.height);
    const double until = now.velocity > 0 ? (now.velocity + speed) / gravity
                                          : 2 * now.height / (speed - now.velocity);
    if (until > step) {
      now.height = std::max(0.0, now.height + (now.velocity - gravity * step / 2) * step);
      now.velocity -= gravity * step;
      break;
    }
    step -= until;
    now.height = 0;
    now.velocity = k * speed;
    ++now.bounces;
    if (speed <= rest_speed) {
      now.velocity = 0;
      now.resting = true;
    }
  }
  return now;
}

}  // namespace exercise
