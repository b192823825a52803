#include "rough_surface.hpp"

namespace exercise {

Eigen::Vector3d after_rough_bounce(const Eigen::Vector3d& /*velocity*/,
                                   const Eigen::Vector3d& /*normal*/, double /*k*/,
                                   double /*friction*/) {
  contact::todo();
}

double rebound_tangent(double /*incidence*/, double /*k*/, double /*friction*/) { contact::todo(); }

}  // namespace exercise
