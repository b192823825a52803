#include "energy_of_a_crash.hpp"

namespace exercise {

EnergyLoss energy_loss(const Body& first, const Body& second, double restitution) {
  //? Bodies that do not approach each other do not collide and lose nothing.
  //? gap: first.velocity > second.velocity
  if (!(first.velocity > second.velocity)) return {0, 0};
  //? The fraction needs the kinetic energy of both bodies before the collision.
  const double before = 0.5 * (first.mass * first.velocity * first.velocity +
                               second.mass * second.velocity * second.velocity);
  //? Seen from the centre of mass, the two bodies act like one with the reduced mass.
  //? gap: first.mass * second.mass / (first.mass + second.mass)
  const double reduced = first.mass * second.mass / (first.mass + second.mass);
  //? Only the energy of the relative motion can be lost, so it needs the closing velocity.
  //? gap: first.velocity - second.velocity
  const double closing = first.velocity - second.velocity;
  //? The relative velocity is multiplied by −k, its energy by k²; what is lost is 1 − k² = (1 −
  //? k)(1 + k), which keeps its digits near k = 1.
  //? gap: (1 - restitution) * (1 + restitution)
  const double lost = 0.5 * reduced * (1 - restitution) * (1 + restitution) * closing * closing;
  //? The fraction is of the energy before.
  //? gap: lost / before
  return {lost, lost / before};
}

}  // namespace exercise
