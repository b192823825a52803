// misconception: impulse-for-velocity
// caught by: the velocity changes by impulse over mass
// seen: https://github.com/appsinacup/godot-box2d/issues/41
#include "force_curve.hpp"

namespace exercise {

ForceEffect apply_force(const std::vector<Sample>& samples, double /*mass*/, double velocity) {
  double impulse = 0;
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    const double width = samples[i + 1].time - samples[i].time;
    impulse += width * (samples[i].force + samples[i + 1].force) / 2;
  }
  const double duration = samples.back().time - samples.front().time;
  return {impulse, impulse / duration, velocity + impulse};
}

}  // namespace exercise
