// misconception: end-of-step-not-asked
// caught by: a step that ends in the air is used whole
#include "roll_back.hpp"

namespace exercise {

double height_at(const Ball& ball, double gravity, double t) {
  return ball.height + (ball.velocity - gravity * t / 2) * t;
}

double last_free(const Ball& ball, double gravity, double step, double tolerance) {
  double free = 0;
  double blocked = step;
  while (blocked - free >= tolerance) {
    const double middle = free + (blocked - free) / 2;
    (height_at(ball, gravity, middle) >= 0 ? free : blocked) = middle;
  }
  return free;
}

}  // namespace exercise
