// misconception: energy-by-subtraction
// caught by: the loss in docking is accurate at orbital speeds
// seen: https://github.com/cusp-ai-oss/kUPS/pull/267
//   a small change of energy is lost in the difference of totals
#include "energy_of_a_crash.hpp"

namespace exercise {

EnergyLoss energy_loss(const Body& first, const Body& second, double restitution) {
  if (!(first.velocity > second.velocity)) return {0, 0};
  const double before = 0.5 * (first.mass * first.velocity * first.velocity +
                               second.mass * second.velocity * second.velocity);
  const double change = (1 + restitution) * (first.velocity - second.velocity);
  const double mass = first.mass + second.mass;
  const double v1 = first.velocity - change * second.mass / mass;
  const double v2 = second.velocity + change * first.mass / mass;
  const double lost = before - 0.5 * (first.mass * v1 * v1 + second.mass * v2 * v2);
  return {lost, lost / before};
}

}  // namespace exercise
