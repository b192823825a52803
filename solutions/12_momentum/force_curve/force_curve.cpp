#include "force_curve.hpp"

namespace exercise {

ForceEffect apply_force(const std::vector<Sample>& samples, double mass, double velocity) {
  //? The impulse is the area under the curve, summed strip by strip.
  double impulse = 0;
  //? n samples bound n − 1 strips.
  //? gap: i + 1 < samples.size()
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    //? The samples need not be equally spaced, so each strip has its own width.
    //? gap: samples[i + 1].time - samples[i].time
    const double width = samples[i + 1].time - samples[i].time;
    //? Between two samples the force is taken as linear: the strip is a trapezium, its width times
    //? the mean of the two forces.
    //? gap: (samples[i].force + samples[i + 1].force) / 2
    impulse += width * (samples[i].force + samples[i + 1].force) / 2;
  }
  //? The mean force acts over the whole time, from the first sample to the last.
  const double duration = samples.back().time - samples.front().time;
  //? Impulse over duration is the mean force; impulse over mass is the change of velocity.
  //? gap: impulse / duration
  //? gap: velocity + impulse / mass
  return {impulse, impulse / duration, velocity + impulse / mass};
}

}  // namespace exercise
