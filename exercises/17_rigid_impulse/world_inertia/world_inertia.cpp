#include "world_inertia.hpp"

namespace exercise {

Eigen::Matrix3d box_inertia(double /*mass*/, const Eigen::Vector3d& /*size*/) { contact::todo(); }

Eigen::Matrix3d about_point(const Eigen::Matrix3d& /*central*/, double /*mass*/,
                            const Eigen::Vector3d& /*offset*/) {
  contact::todo();
}

Eigen::Matrix3d in_world(const Eigen::Matrix3d& /*inertia*/, const Eigen::Matrix3d& /*rotation*/) {
  contact::todo();
}

}  // namespace exercise
