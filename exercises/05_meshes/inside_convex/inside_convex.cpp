#include "inside_convex.hpp"

namespace exercise {

Eigen::Vector3d outward_normal(const contact::Triangle<double>& /*face*/) { contact::todo(); }

double ahead(const Eigen::Vector3d& /*point*/, const contact::Triangle<double>& /*face*/) {
  contact::todo();
}

Where inside_convex(const contact::Mesh<double>& /*mesh*/, const Eigen::Vector3d& /*point*/) {
  contact::todo();
}

}  // namespace exercise
