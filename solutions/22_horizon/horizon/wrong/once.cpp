// misconception: normal-turned-once
// caught by: one pillar, head on
// seen: https://meritnation.sg/ask-answer/question/if-the-light-ray-incidents-ona-mirror-and-the-mirror-is-rota/work-and-energy/13985653
//   a quiz offers that a reflected ray turns by the angle of the mirror
#include "horizon.hpp"

namespace exercise {

double horizon(const std::vector<Hit>& hits, double speed, double error, double tolerance) {
  double apart = error;
  double angle = 0;  // between the two paths, rad
  double time = 0;
  for (const Hit& hit : hits) {
    const double next = apart + angle * hit.flight;
    if (next >= tolerance) break;
    apart = next;
    time += hit.flight / speed;
    angle += apart / (hit.radius * hit.cosine);
  }
  if (!(angle > 0)) return std::numeric_limits<double>::infinity();
  return time + (tolerance - apart) / angle / speed;
}

}  // namespace exercise
