// misconception: thickness-twice
// caught by: both move
#include "nothing_passes.hpp"

namespace exercise {

namespace {

/// The longest path of a point of one body in a step, m.
double max_path_length(const Mover& mover, double step) {
  return (mover.speed + mover.acceleration * step / 2 +
          mover.angular_velocity * mover.bounding_radius) *
         step;
}

}  // namespace

Proof prove(const Mover& a, const Mover& b, double step, double thickness) {
  const double displacement = max_path_length(a, step) + max_path_length(b, step);
  return {displacement, displacement <= 2 * thickness};
}

}  // namespace exercise
