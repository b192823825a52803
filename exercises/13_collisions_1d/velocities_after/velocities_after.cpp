#include "velocities_after.hpp"

namespace exercise {

After collide(const Body& /*first*/, const Body& /*second*/, double /*restitution*/) {
  contact::todo();
}

}  // namespace exercise
