#include "largest_step.hpp"

namespace exercise {

State after_step(const State& /*now*/, double /*stiffness*/, double /*damping*/, double /*mass*/,
                 double /*step*/) {
  contact::todo();
}

double largest_step(double /*stiffness*/, double /*damping*/, double /*mass*/) { contact::todo(); }

}  // namespace exercise
