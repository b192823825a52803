// misconception: peak-force
// caught by: the area under a rising and falling force is that of trapezoids
// seen: https://mistakemaster.com/topics/4.2 the second trap: the peak instead of the area
#include "force_curve.hpp"

namespace exercise {

ForceEffect apply_force(const std::vector<Sample>& samples, double mass, double velocity) {
  double peak = 0;
  for (const Sample& sample : samples) {
    if (std::abs(sample.force) > std::abs(peak)) peak = sample.force;
  }
  const double duration = samples.back().time - samples.front().time;
  const double impulse = peak * duration;
  return {impulse, impulse / duration, velocity + impulse / mass};
}

}  // namespace exercise
