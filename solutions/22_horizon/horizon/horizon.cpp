#include "horizon.hpp"

namespace exercise {

// Two parallel paths at the distance d meet the pillar d / cosine apart along its surface. So their
// normals differ by the angle d / (cosine radius), and the reflected paths by twice that.
double horizon(const std::vector<Hit>& hits, double speed, double error, double tolerance) {
  double apart = error;
  double angle = 0;  // between the two paths, rad
  double time = 0;
  for (const Hit& hit : hits) {
    const double next = apart + angle * hit.flight;
    if (next >= tolerance) break;
    apart = next;
    time += hit.flight / speed;
    angle += 2 * apart / (hit.radius * hit.cosine);
  }
  if (!(angle > 0)) return std::numeric_limits<double>::infinity();
  return time + (tolerance - apart) / angle / speed;
}

}  // namespace exercise
