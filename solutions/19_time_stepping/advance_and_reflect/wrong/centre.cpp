// misconception: sphere-as-point
// caught by: a ball is larger than its centre
#include "advance_and_reflect.hpp"

namespace exercise {

Ball advance(const Ball& ball, const std::vector<Wall>& walls, double k, double step) {
  Ball now = ball;
  for (int turns = 0; turns < 1000; ++turns) {
    double first = std::numeric_limits<double>::infinity();
    const Wall* met = nullptr;
    for (const Wall& wall : walls) {
      const double gap = wall.normal.dot(now.centre) - wall.offset - 0;
      const double rate = wall.normal.dot(now.velocity);
      if (rate >= 0) continue;
      const double time = std::max(0.0, gap) / -rate;
      if (time < first) {
        first = time;
        met = &wall;
      }
    }
    if (met == nullptr || first > step) break;
    now.centre += now.velocity * first;
    now.velocity -= (1 + k) * met->normal.dot(now.velocity) * met->normal;
    ++now.impacts;
    step -= first;
  }
  now.centre += now.velocity * step;
  return now;
}

}  // namespace exercise
