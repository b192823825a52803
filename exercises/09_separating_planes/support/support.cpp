#include "support.hpp"

namespace exercise {

Eigen::Vector3d support(const Body& /*body*/, const Eigen::Vector3d& /*direction*/) {
  contact::todo();
}

Eigen::Vector3d support_of_difference(const Body& /*first*/, const Body& /*second*/,
                                      const Eigen::Vector3d& /*direction*/) {
  contact::todo();
}

}  // namespace exercise
