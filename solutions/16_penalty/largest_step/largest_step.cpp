#include "largest_step.hpp"

namespace exercise {

State after_step(const State& now, double stiffness, double damping, double mass, double step) {
  //? Spring and damper act against the penetration and against its change, as they are now.
  //? gap: stiffness * now.penetration + damping * now.approach
  const double force = stiffness * now.penetration + damping * now.approach;
  //? The force pushes out, so it reduces the approach.
  //? gap: now.approach - step * force / mass
  const double approach = now.approach - step * force / mass;
  //? The penetration changes with the new velocity.
  //? gap: now.penetration + step * approach
  return {now.penetration + step * approach, approach};
}

double largest_step(double stiffness, double damping, double mass) {
  //? At the limit h² k + 2 h c = 4 m, a quadratic equation for h.
  //? gap: damping * damping + 4 * stiffness * mass
  const double root = std::sqrt(damping * damping + 4 * stiffness * mass);
  //? Of its two solutions the positive one, without a difference: for strong damping the root is
  //? almost c.
  //? gap: 4 * mass / (damping + root)
  return 4 * mass / (damping + root);
}

}  // namespace exercise
