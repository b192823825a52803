#include "energy_of_a_crash.hpp"

namespace exercise {

EnergyLoss energy_loss(const Body& /*first*/, const Body& /*second*/, double /*restitution*/) {
  contact::todo();
}

}  // namespace exercise
