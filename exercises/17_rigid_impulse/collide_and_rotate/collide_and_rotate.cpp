#include "collide_and_rotate.hpp"

namespace exercise {

After collide(const Body& /*a*/, const Body& /*b*/, const Eigen::Vector3d& /*point*/,
              const Eigen::Vector3d& /*normal*/, double /*e*/) {
  contact::todo();
}

}  // namespace exercise
