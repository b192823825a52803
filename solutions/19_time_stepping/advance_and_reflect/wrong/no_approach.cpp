// misconception: bounce-when-separating
// caught by: what touches and leaves is left alone
#include "advance_and_reflect.hpp"

namespace exercise {

Ball advance(const Ball& ball, const std::vector<Wall>& walls, double k, double step) {
  Ball now = ball;
  for (int turns = 0; turns < 1000; ++turns) {
    double first = std::numeric_limits<double>::infinity();
    const Wall* met = nullptr;
    for (const Wall& wall : walls) {
      const double gap = wall.normal.dot(now.centre) - wall.offset - ball.radius;
      const double rate = wall.normal.dot(now.velocity);
      if (rate == 0 || (rate > 0 && gap > 0)) continue;
      const double time = rate < 0 ? std::max(0.0, gap) / -rate : 0;
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
