// misconception: peak-force
// caught by: the area under a rising and falling force is that of trapezoids
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
