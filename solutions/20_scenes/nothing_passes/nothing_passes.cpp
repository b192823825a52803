#include "nothing_passes.hpp"

namespace exercise {

namespace {

/// The longest path of a point of one body in a step, m.
double longest_path(const Mover& mover, double step) {
  return (mover.speed + mover.acceleration * step / 2 + mover.spin * mover.reach) * step;
}

}  // namespace

Proof prove(const Mover& a, const Mover& b, double step, double thickness) {
  const double displacement = longest_path(a, step) + longest_path(b, step);
  return {displacement, displacement <= thickness};
}

}  // namespace exercise
