#include "bounce_impulse.hpp"

namespace exercise {

Eigen::Vector3d impulse_of(double mass, const Eigen::Vector3d& /*before*/,
                           const Eigen::Vector3d& after) {
  // The momentum afterwards. An impulse is a change of momentum: what is missing?
  [[maybe_unused]] const Eigen::Vector3d momentum_after = mass * after;
  contact::todo();
}

Eigen::Vector3d average_force(const Eigen::Vector3d& /*impulse*/, double /*duration*/) {
  contact::todo();
}

}  // namespace exercise
