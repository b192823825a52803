// misconception: horizon-at-a-hit
// caught by: from pillar to pillar
// seen: https://github.com/arbor-sim/arbor/issues/717
//   the time of a crossing is reported at the end of its step
#include "horizon.hpp"

namespace exercise {

double horizon(const std::vector<Hit>& hits, double speed, double error, double tolerance) {
  double apart = error;
  double angle = 0;  // between the two paths, rad
  double time = 0;
  for (const Hit& hit : hits) {
    const double next = apart + angle * hit.flight;
    if (next >= tolerance) return time + hit.flight / speed;
    apart = next;
    time += hit.flight / speed;
    angle += 2 * apart / (hit.radius * hit.cosine);
  }
  if (!(angle > 0)) return std::numeric_limits<double>::infinity();
  return time + (tolerance - apart) / angle / speed;
}

}  // namespace exercise
