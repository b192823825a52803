#include "advance_and_reflect.hpp"

namespace exercise {

Ball advance(const Ball& ball, const std::vector<Wall>& walls, double k, double step) {
  //? The ball is moved as a copy.
  Ball now = ball;
  //? One step may have several impacts; the number is limited, because they may accumulate.
  for (int turns = 0; turns < 1000; ++turns) {
    //? The search for the earliest impact begins with none.
    double first = std::numeric_limits<double>::infinity();
    const Wall* met = nullptr;
    //? The ball touches a wall when its centre is one radius away, so this is the free distance.
    //? gap: wall.normal.dot(now.centre)
    for (const Wall& wall : walls) {
      const double gap = wall.normal.dot(now.centre) - wall.offset - ball.radius;
      //? A ball that moves away from a wall or along it does not hit it.
      //? gap: rate >= 0
      const double rate = wall.normal.dot(now.velocity);
      if (rate >= 0) continue;
      //? Distance over closing speed is the time of impact. A ball that rounding has put into the
      //? wall hits it now.
      //? gap: std::max(0.0, gap) / -rate
      const double time = std::max(0.0, gap) / -rate;
      //? The earliest of all walls counts.
      //? gap: time < first
      if (time < first) {
        first = time;
        met = &wall;
      }
    }
    //? An impact after the end of the step belongs to a later step.
    //? gap: first > step
    if (met == nullptr || first > step) break;
    //? The ball advances to the impact.
    //? gap: now.velocity * first
    now.centre += now.velocity * first;
    //? Of the velocity only the normal component changes: it is reversed and multiplied by k.
    //? gap: (1 + k) * met->normal.dot(now.velocity)
    now.velocity -= (1 + k) * met->normal.dot(now.velocity) * met->normal;
    //? What remains of the step is still to be used.
    //? gap: step -= first
    ++now.impacts;
    step -= first;
  }
  //? After the last impact the ball flies freely to the end of the step.
  now.centre += now.velocity * step;
  //? This is the ball at the end of the step.
  return now;
}

}  // namespace exercise
