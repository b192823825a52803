// misconception: mean-of-samples
// caught by: the area under a rising and falling force is that of trapezoids
// seen: https://github.com/AirChem/F0AM/issues/17
#include "force_curve.hpp"

namespace exercise {

ForceEffect apply_force(const std::vector<Sample>& samples, double mass, double velocity) {
  double sum = 0;
  for (const Sample& sample : samples) sum += sample.force;
  const double duration = samples.back().time - samples.front().time;
  const double impulse = sum / static_cast<double>(samples.size()) * duration;
  return {impulse, impulse / duration, velocity + impulse / mass};
}

}  // namespace exercise
