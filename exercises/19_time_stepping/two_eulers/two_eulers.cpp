#include "two_eulers.hpp"

namespace exercise {

Body explicit_euler(const Body& body, const Eigen::Vector3d& acceleration, double step) {
  // The velocity after the step is the same in both methods. Which velocity moves the body?
  [[maybe_unused]] const Eigen::Vector3d velocity = body.velocity + acceleration * step;
  contact::todo();
}

Body semi_implicit_euler(const Body& /*body*/, const Eigen::Vector3d& /*acceleration*/,
                         double /*step*/) {
  contact::todo();
}

}  // namespace exercise
