#include "verlet_step.hpp"

namespace exercise {

Swinging verlet_step(const Swinging& body, double angular_frequency, double step) {
  //? The acceleration of a harmonic oscillator is −ω²x.
  //? gap: angular_frequency * angular_frequency
  const double pull = angular_frequency * angular_frequency;
  //? Half a step with the acceleration at the old position gives the velocity in the middle.
  //? gap: pull * body.position * step / 2
  const double middle = body.velocity - pull * body.position * step / 2;
  //? The whole step is made with the velocity in the middle.
  //? gap: middle * step
  const double position = body.position + middle * step;
  //? The second half of the change of velocity uses the acceleration at the new position.
  //? gap: pull * position * step / 2
  return {position, middle - pull * position * step / 2};
}

}  // namespace exercise
