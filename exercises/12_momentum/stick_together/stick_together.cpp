#include "stick_together.hpp"

namespace exercise {

Eigen::Vector3d total_momentum(const std::vector<Body>& /*bodies*/) { contact::todo(); }

Eigen::Vector3d velocity_together(const std::vector<Body>& /*bodies*/) { contact::todo(); }

}  // namespace exercise
