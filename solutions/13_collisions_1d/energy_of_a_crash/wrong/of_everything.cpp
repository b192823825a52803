// misconception: fraction-of-everything
// caught by: the truck and the parked car
// seen: https://imathworks.com/physics/relation-between-coefficient-of-restitution-and-k-e
#include "energy_of_a_crash.hpp"

namespace exercise {

EnergyLoss energy_loss(const Body& first, const Body& second, double restitution) {
  if (!(first.velocity > second.velocity)) return {0, 0};
  const double before = 0.5 * (first.mass * first.velocity * first.velocity +
                               second.mass * second.velocity * second.velocity);
  const double lost = (1 - restitution * restitution) * before;
  return {lost, lost / before};
}

}  // namespace exercise
