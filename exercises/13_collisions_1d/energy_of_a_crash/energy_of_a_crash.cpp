#include "energy_of_a_crash.hpp"

namespace exercise {

Bill bill(const Body& /*first*/, const Body& /*second*/, double /*restitution*/) {
  contact::todo();
}

}  // namespace exercise
