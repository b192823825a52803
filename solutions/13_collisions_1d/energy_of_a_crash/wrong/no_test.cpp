// misconception: no-approach-test
// caught by: bodies that do not approach lose nothing
// seen: FCA, slide "Collisions Between Spheres (1)"
//   no test in the steps a to d
#include "energy_of_a_crash.hpp"

namespace exercise {

EnergyLoss energy_loss(const Body& first, const Body& second, double restitution) {
  const double before = 0.5 * (first.mass * first.velocity * first.velocity +
                               second.mass * second.velocity * second.velocity);
  const double reduced = first.mass * second.mass / (first.mass + second.mass);
  const double closing = first.velocity - second.velocity;
  const double lost = 0.5 * reduced * (1 - restitution) * (1 + restitution) * closing * closing;
  return {lost, before > 0 ? lost / before : 0};
}

}  // namespace exercise
