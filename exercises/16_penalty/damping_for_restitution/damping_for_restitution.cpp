#include "damping_for_restitution.hpp"

namespace exercise {

double damping_to_zero_penetration(double /*restitution*/, double /*stiffness*/, double /*mass*/) {
  contact::todo();
}

double damping_to_zero_force(double /*restitution*/, double /*stiffness*/, double /*mass*/) {
  contact::todo();
}

}  // namespace exercise
