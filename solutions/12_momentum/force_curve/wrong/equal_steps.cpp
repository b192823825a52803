// misconception: mean-of-samples
// caught by: samples need not be equally far apart
#include "force_curve.hpp"

namespace exercise {

Push push(const std::vector<Sample>& samples, double mass, double velocity) {
  double impulse = 0;
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    const double width =
        (samples.back().time - samples.front().time) / static_cast<double>(samples.size() - 1);
    impulse += width * (samples[i].force + samples[i + 1].force) / 2;
  }
  const double duration = samples.back().time - samples.front().time;
  return {impulse, impulse / duration, velocity + impulse / mass};
}

}  // namespace exercise
