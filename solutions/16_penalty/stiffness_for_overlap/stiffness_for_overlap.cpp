#include "stiffness_for_overlap.hpp"

namespace exercise {

// At the greatest overlap the body is at rest, and has fallen by the height and the overlap: the
// spring holds that energy.
double stiffness_for_overlap(double mass, double height, double gravity, double overlap) {
  return 2 * mass * gravity * (height + overlap) / (overlap * overlap);
}

// The body oscillates about the overlap m g / k at which it would rest, and at the first touch it
// is above that. With tan β = ω v / g it is β / ω late: it is above during 2 β of the period.
double step_for_contact(double mass, double height, double gravity, double stiffness, int steps) {
  const double frequency = std::sqrt(stiffness / mass);
  const double speed = std::sqrt(2 * gravity * height);
  const double above = std::atan2(frequency * speed, gravity);
  return 2 * (std::numbers::pi - above) / frequency / steps;
}

}  // namespace exercise
