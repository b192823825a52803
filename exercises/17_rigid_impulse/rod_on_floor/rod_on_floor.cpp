#include "rod_on_floor.hpp"

namespace exercise {

Motion after_floor(const Body& /*body*/, const Eigen::Vector2d& /*point*/, double /*e*/,
                   double /*friction*/) {
  contact::todo();
}

}  // namespace exercise
